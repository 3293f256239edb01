// Expressions that a loop reads again are compiled at their second reading. The bytes choose the statements of a loop's
// body; the loop has to say what the same statements say when each pass is written out, where nothing is read twice.
#include "parser/parse.h"
#include "tests/fuzz/target.h"

#include <array>

namespace {

constexpr int kPasses = 4;

/// Text from bytes: each byte is a choice, and where they end the shortest is chosen.
class Writer {
public:
    explicit Writer(const fuzz::Bytes& bytes) : bytes_(bytes) {}

    std::string body()
    {
        std::string text;
        for (int i = 0; i < 6 && at_ < bytes_.size(); ++i) text += statement();
        return text;
    }

private:
    std::size_t choice(std::size_t count) { return at_ < bytes_.size() ? bytes_[at_++] % count : 0; }

    std::string statement()
    {
        static constexpr std::array kNumbers = {"A", "B", "U", "L[mod(I,3)]"};
        switch (choice(7)) {
        case 0: return "#debug vstr(3," + vector(0) + ",\" \",0,17)\n";
        case 1: return std::string("#declare ") + kNumbers[choice(kNumbers.size())] + "=" + number(0) + ";\n";
        case 2: return "#if(" + number(0) + ")#debug \"y\"#else #debug \"n\"#end\n";
        case 3: return "#debug str(" + number(0) + ",0,17)\n";
        case 4: return std::string(choice(2) ? "#declare V=" : "#declare Q[mod(I,2)]=") + vector(0) + ";\n";
        case 5: return "#debug vstr(5," + mixed(0) + ",\" \",0,17)\n";
        default: return "M(" + vector(0) + "," + mixed(0) + ")\n";
        }
    }

    std::string mixed(int depth) { return choice(2) ? vector(depth) : number(depth); }

    std::string number(int depth)
    {
        static constexpr std::array kPlain = {
            "I", "A",   "B",   "L[mod(I,3)]", "U",  "V.x",           "K.green",  "1",
            "0", "2.5", "1e9", "0.3333333",   "pi", "Q[mod(I,2)].z", "K.filter", "rand(R)"};
        static constexpr std::array kSigns = {"+", "-", "*", "/", "<", ">", "<=", ">=", "=", "!=", "&", "|"};
        static constexpr std::array kOne = {"sin",     "abs", "floor", "int",  "exp", "F",
                                            "degrees", "-",   "!",     "ceil", "atan"};
        static constexpr std::array kTwo = {"max", "min", "mod", "pow", "atan2", "G", "div"};
        const std::size_t form = choice(12);
        if (depth > 4 || form < 4) return kPlain[choice(kPlain.size())];
        const auto inner = [&] { return number(depth + 1); };
        const std::string first = inner();
        switch (form) {
        case 4: return "(" + first + kSigns[choice(kSigns.size())] + inner() + ")";
        case 5: return first + kSigns[choice(4)] + inner();
        case 6: return std::string(kOne[choice(kOne.size())]) + "(" + first + ")";
        case 7: return std::string(kTwo[choice(kTwo.size())]) + "(" + first + "," + inner() + ")";
        case 8: {
            const std::string yes = inner();
            return "(" + first + "?" + yes + ":" + inner() + ")";
        }
        case 9: {
            const std::string second = inner();
            return "select(" + first + "," + second + "," + inner() + ")";
        }
        case 10: return "vlength(" + vector(depth + 1) + ")";
        default: return "vdot(" + vector(depth + 1) + "," + vector(depth + 2) + ")";
        }
    }

    std::string vector(int depth)
    {
        static constexpr std::array kPlain = {"V", "Q[mod(I,2)]", "x", "<1,I,3>", "z"};
        const std::size_t form = choice(10);
        if (depth > 4 || form < 3) return kPlain[choice(kPlain.size())];
        const std::string first = vector(depth + 1);
        switch (form) {
        case 3: return "(" + first + (choice(2) ? "+" : "-") + vector(depth + 1) + ")";
        case 4: return number(depth + 1) + "*" + first;
        case 5: return "vrotate(" + first + "," + vector(depth + 1) + ")";
        case 6: return "vcross(" + first + "," + vector(depth + 1) + ")";
        case 7: return "(" + number(depth + 1) + "?" + first + ":" + vector(depth + 1) + ")";
        case 8: return "-" + first;
        default: {
            const std::string a = number(depth + 1), b = number(depth + 1);
            return "<" + a + "," + b + "," + number(depth + 1) + ">";
        }
        }
    }

    const fuzz::Bytes& bytes_;
    std::size_t at_ = 0;
};

constexpr const char* kStart = "#version 3.7;\n#declare A=1.5;#declare B=-2;#declare V=<1,2,3>;#declare "
                               "W=<4,5>;#declare L=array[3]{1,-2,5}#declare Q=array[2]{<1,2,3>,<4,5,6>}\n"
                               "#declare K=rgbft<.1,.2,.3,.4,.5>;#declare U=3;#declare R=seed(7);#declare "
                               "F=function(x){x*x-1}#declare G=function(x,y){x-y/2}\n"
                               "#macro M(P,Q)#debug vstr(5,P+Q*2,\" \",0,17)#end\n";

struct Said {
    std::string text;
    bool refused = false;
};

void keep_debug(void* said, const parser::Message& message)
{
    if (message.severity != parser::Severity::Debug) return;
    static_cast<Said*>(said)->text += fuzz::without_sign_of_nan(message_text(message));
}

Said said_by(const std::string& text)
{
    Said said;
    parser::Options options;
    options.most_tokens = 50'000;
    try {
        parser::parse_text(text, "fuzz.pov", options, keep_debug, &said);
    } catch (const parser::Error&) {
        said.refused = true;
    }
    return said;
}

}  // namespace

void fuzz::one(const Bytes& bytes)
{
    static const bool sound = !said_by(kStart).refused;
    require(sound, "what stands before the loop is refused");
    const std::string body = Writer(bytes).body();
    std::string unrolled = kStart;
    for (int i = 0; i < kPasses; ++i) unrolled += "#declare I=" + std::to_string(i) + ";\n" + body;
    const Said plain = said_by(unrolled),
               looped = said_by(kStart + ("#declare I=0;#while(I<" + std::to_string(kPasses) + ")\n") + body +
                                "#declare I=I+1;#end\n");
    if (plain.text != looped.text || plain.refused != looped.refused)
        fail("a loop says otherwise than its passes:\n" + body + "\nlooped: " + looped.text +
             "\npasses: " + plain.text);
}

std::vector<fuzz::Bytes> fuzz::seeds()
{
    std::vector<Bytes> all;
    for (std::uint32_t seed = 1; seed < 40; ++seed) all.push_back(noise(seed, 60));
    return all;
}
