#include "render/app/options/help.h"
#include "render/app/options/option_table.h"
#include "render/app/options/own_options.h"
#include "render/app/options/sub_commands.h"
#include "render/app/options/switch_table.h"

#include <fmt/format.h>

#include <algorithm>

namespace app {

namespace {

/// Words of the own options that are one of several: "--isa=v2 --isa=v3 ...".
std::string own_words()
{
    std::string words;
    for (const OwnOption& option : own_options()) {
        const std::string name = "--" + std::string(option.name);
        if (option.value_may_lack || option.value.empty()) words += name + " ";
        if (option.value.empty()) continue;
        if (option.value.find('|') == std::string_view::npos) {
            words += option.value_may_lack ? fmt::format("{}={} ", name, option.value) : name + "= ";
        } else {
            std::string_view rest = option.value;
            for (std::size_t bar = 0; bar != std::string_view::npos;
                 rest.remove_prefix(std::min(bar + 1, rest.size()))) {
                bar = rest.find('|');
                words += fmt::format("{}={} ", name, rest.substr(0, bar));
            }
        }
    }
    return words;
}

std::string switch_words()
{
    std::string words;
    for (const Switch& one : switch_table()) {
        if (*one.prefix) continue;
        words += fmt::format("+{0} -{0} ", one.letters);
    }
    return words;
}

std::string keyword_words()
{
    std::string words;
    for (const Option& option : option_table())
        if (option.state != State::Obsolete) words += std::string(option.keyword) + "= ";
    return words;
}

/// The words that make another program of whittle.
std::string command_words()
{
    std::string words;
    for (const SubCommand& command : kSubCommands) words += std::string(command.name) + " ";
    return words;
}

}  // namespace

std::string zsh_completion()
{
    return "#compdef whittle povray\n# Completion of whittle's command line in zsh.\n_whittle() {\n"
           "    local -a words\n"
           "    case $PREFIX in\n"
           "        --*) words=(" +
           own_words() +
           ") ;;\n"
           "        [+-]*) words=(" +
           switch_words() +
           ") ;;\n"
           "        *) words=(" +
           keyword_words() +
           ")\n"
           "            (( CURRENT == 2 )) && words+=(" +
           command_words() +
           ")\n"
           "            _files -g '*.(pov|ini)(-.)' ;;\n"
           "    esac\n"
           "    compadd -S '' -- ${(M)words:#*=}\n"
           "    compadd -- ${words:#*=}\n"
           "}\n"
           "_whittle \"$@\"\n";
}

std::string bash_completion()
{
    return "# Completion of whittle's command line in bash: source this file.\n_whittle()\n{\n"
           "    local word=${COMP_LINE:0:COMP_POINT} words prefix\n    word=${word##*[[:space:]]}\n"
           "    case $word in\n"
           "        --json=*|--allow-write=*|+I*|+i*|+O*|+o*|+L*|+l*|*_Name=*|Library_Path=*)\n"
           "            case $word in *=*) prefix=${word%%=*}= ;; *) prefix=${word:0:2} ;; esac\n"
           "            mapfile -t COMPREPLY < <(compgen -f -P \"$prefix\" -- \"${word#\"$prefix\"}\") ;;\n"
           "        --*) words=\"" +
           own_words() +
           "\" ;;\n"
           "        [+-]*) words=\"" +
           switch_words() +
           "\" ;;\n"
           "        *) words=\"" +
           keyword_words() + command_words() +
           "\"\n            mapfile -t COMPREPLY < <(compgen -f -X '!*.pov' -- \"$word\"; compgen -f -X '!*.ini' -- "
           "\"$word\"; compgen -d -S / -- \"$word\") ;;\n"
           "    esac\n"
           "    [[ -n $words ]] && mapfile -t -O \"${#COMPREPLY[@]}\" COMPREPLY < <(compgen -W \"$words\" -- "
           "\"$word\")\n"
           "    # bash breaks words at '=': what stands before it is on the line already.\n"
           "    if [[ $word == *=* && $COMP_WORDBREAKS == *=* ]]; then "
           "COMPREPLY=(\"${COMPREPLY[@]#\"${word%\"${word##*=}\"}\"}\"); fi\n"
           "    [[ ${#COMPREPLY[@]} == 1 && ${COMPREPLY[0]} == *[=/] ]] && compopt -o nospace 2>/dev/null\n    return "
           "0\n}\n"
           "complete -F _whittle whittle povray\n";
}

}  // namespace app
