// Loops and macros over numbers, texts, arrays and objects are compiled as a whole. The bytes choose a program;
// compiled it has to say what it says read word by word: the same texts, warnings and error, at the same places, and
// the same objects.
#include "parser/parse.h"
#include "render/scene/description.h"
#include "tests/fuzz/target.h"

#include <array>

namespace {

/// Text from bytes: each byte is a choice, and where they end the shortest is chosen.
class Program {
public:
    explicit Program(const fuzz::Bytes& bytes) : bytes_(bytes) {}

    std::string text()
    {
        std::string all =
            "#version 3.7;\n#declare A=1.5;#declare B=-2;#declare I=0;#declare J=0;#declare V=<1,2,3>;#declare "
            "W=<4,5>;\n"
            "#declare L=array[4]{1,-2,5,7}#declare Q=array[2][2]{{1,2},{3,4}}#declare P=array[2]{<1,2,3>,<4,5,6>}\n"
            "#declare T=array[3]{\"x\",\"yy\",\"\"}#declare S=\"text\";#declare K=rgbft<.1,.2,.3,.4,.5>;\n"
            "#declare R=seed(7);#declare F=function(x){x*x-1}#declare Depth=0;#declare Steps=0;\n"
            "#declare Ball=sphere{0,1}#declare Paint=texture{pigment{rgb<.1,.2,.3>}}#declare Tiles=texture{checker "
            "texture{Paint}texture{Paint finish{phong 1}}}#declare Shine=finish{specular .5}#declare "
            "Move=transform{rotate y*20 translate x}#declare Green=rgb<0,1,0>;#declare "
            "Curve=spline{cubic_spline 0,<0,1>,1,<2,3>,2,<5,1>,4,<1,0>}\n"
            "#macro Show()#debug concat(str(A,0,9),\" \",str(B,0,9),\" \",str(I,0,9),\" \",vstr(3,V,\",\",0,9),\" \",S,"
            "\" \",str(L[0],0,9),\" \",str(L[2],0,9),\" \",str(Q[1][0],0,9),\" \",T[1],\" "
            "\",str(rand(R),0,9),\"\\n\")#end\n"
            "#macro Tail(X)(X*2-1)#end\n#macro Long(X)#local Y=X+1;#local Z=Y*Y;(Z-Y)#end\n"
            "#macro Again(N)#if(N<1)(N)#else(N+Again(N-1)*2)#end#end\n#macro Twice(X)X*2 #end#macro Same(X)X #end\n"
            "#macro Side(X)#declare B=B+X;#declare L[1]=B;#local X=X+1;(X+rand(R))#end\n"
            "#macro Odd(X)#local Q2=1/X;(sqrt(X)+Q2)#end\n#macro Both(X)#declare I=I+1;Long(X)#end\n"
            "#macro Made(X)#declare New=X;#local C=array[2];#declare C[1]=X;(C[1]+New)#end\n";
        for (const char* const name : {"M0", "M1", "M2"}) {
            static constexpr std::array kParameters = {"X,Y", "X", "A,X", "L,Y", "X,S"};
            all += std::string("#macro ") + name + "(" + kParameters[choice(kParameters.size())] +
                   ")\n#declare Depth=Depth+1;#if(Depth<5)\n" + body(1) + "#end\n#declare Depth=Depth-1;\n#end\n";
        }
        return all + "#fopen Out \"w.txt\" write\n#for(Pass,1,7)\n" + body(0) +
               "Show()\n#end\n#fclose Out #fopen In \"w.txt\" read\n#while(defined(In))#read(In,Line)#debug "
               "concat(Line,\"\\n\")#end\n";
    }

private:
    std::size_t choice(std::size_t count) { return at_ < bytes_.size() ? bytes_[at_++] % count : 0; }
    bool rarely() { return choice(24) == 23; }

    std::string body(int depth)
    {
        std::string text;
        for (std::size_t i = 1 + choice(depth > 2 ? 2 : 5); i > 0 && at_ < bytes_.size(); --i) text += statement(depth);
        return text;
    }

    std::string target()
    {
        static constexpr std::array kNumbers = {"A",    "B",    "I",           "J",       "X", "Y",
                                                "New",  "L[1]", "L[mod(I,4)]", "Q[1][0]", "A", "Q[0][mod(I,2)]",
                                                "L[A]", "B",    "Pass"};
        return kNumbers[choice(kNumbers.size())];
    }

    std::string declared()
    {
        const bool local = choice(4) == 3;
        const std::string word = local ? "#local " : "#declare ", end = rarely() ? "\n" : ";\n";
        switch (choice(8)) {
        case 0: return word + (choice(3) ? "V=" : "P[mod(I,2)]=") + vector(0) + end;
        case 1: return word + (choice(3) ? "S=" : "T[mod(I,3)]=") + string(0) + end;
        case 2:
            if (rarely()) return word + (choice(2) ? "A=" : "X=") + vector(0) + end;
            if (rarely()) return word + "C=L" + end + "#declare C[0]=" + number(0) + ";#declare B=C[0]+L[0];\n";
            if (rarely()) return word + "L=array[2+mod(I,3)]" + end;
            return word + "E=array[3]" + (choice(2) ? ";" : "") + "#declare E[1]=" + number(0) + ";#declare A=E[1];\n";
        case 3:
            return word + "K=" +
                   (choice(2) ? "K*0.5+<" + number(2) + ",1,0,0,0>"
                              : (choice(3)   ? "rgb "
                                 : choice(2) ? "color rgbt "
                                             : "rgbf ") +
                                    (choice(2) ? vector(2) : "<" + number(2) + ",1,0,.5>")) +
                   end;
        case 4: {  // numbers, vectors and colours that turn into each other
            static constexpr std::array kTurning = {"V", "W", "A", "K", "X"};
            const std::string name = kTurning[choice(kTurning.size())];
            if (choice(3) == 0) return word + name + "=" + name + "*2+" + number(1) + end;
            return word + name + "=" + (choice(3) ? number(0) : (choice(2) ? "rgb " : "") + vector(0)) + end;
        }
        default: return word + target() + "=" + number(0) + end;
        }
    }

    std::string statement(int depth)
    {
        const std::size_t form = depth > 3 ? choice(8) : choice(29);
        switch (form) {
        case 8:
        case 9: return "#if(" + condition() + ")\n" + body(depth + 1) + "#end\n";
        case 10:
            return "#if(" + condition() + ")\n" + body(depth + 1) + "#elseif(" + condition() + ")\n" + body(depth + 1) +
                   "#else\n" + body(depth + 1) + "#end\n";
        case 11: {
            const std::string name = "I" + std::to_string(depth);
            return "#local " + name + "=0;\n#while(" + name + "<" + std::to_string(choice(7)) +
                   (choice(3) ? "" : "&" + condition()) + ")\n#local " + name + "=" + name + "+1;\n" + body(depth + 1) +
                   "#end\n";
        }
        case 12:
        case 13:
            return std::string("#for(") + (choice(2) ? "J" : "Y") + ",0," + std::to_string(choice(6)) +
                   (choice(4) ? "" : "," + number(2)) + ")\n" + body(depth + 1) + "#end\n";
        case 14: {
            std::string text = "#switch(" + number(1) + ")\n";
            for (std::size_t i = 1 + choice(3); i > 0; --i)
                text += (choice(3) ? "#case(" + number(2) + ")\n" : "#range(" + number(2) + "," + number(2) + ")\n") +
                        body(depth + 1) + (choice(2) ? "#break\n" : "");
            return text + (choice(2) ? "#else\n" + body(depth + 1) : "") + "#end\n";
        }
        case 15: return "#ifdef(" + std::string(choice(2) ? "New" : "X") + ")\n" + body(depth + 1) + "#end\n";
        case 16:
        case 17:
        case 18: {
            const std::size_t which = choice(3);
            static constexpr std::array kGiven = {"A", "B", "L[1]", "I", "L", "S", "V", "Q[1][1]"};
            std::string text = "M" + std::to_string(which) + "(";
            for (int i = 0; i < 2; ++i)
                text += std::string(i == 0      ? ""
                                    : choice(6) ? ","
                                                : " ") +
                        (choice(2)   ? std::string(kGiven[choice(kGiven.size())])
                         : choice(5) ? number(1)
                                     : string(1));
            return text + ")\n";
        }
        case 22: return "Ball\n";
        case 23:
        case 24:
        case 25: return object(depth);
        case 26: {
            const std::string loop = "#for(J,1," + std::to_string(choice(7)) + ")\n";
            switch (choice(3)) {
            case 0:
                return "union{" + loop + object(depth + 1) + (choice(3) ? "" : declared()) + "#end " +
                       modifiers(depth) + "}\n";
            case 1:
                return "blob{threshold .5 " + loop + component(depth + 1) + "#end sphere{0,1,1}" + modifiers(depth) +
                       "}\n";
            default: return "mesh{" + loop + face(depth + 1) + "#end triangle{x,y,z}" + modifiers(depth) + "}\n";
            }
        }
        case 27: return "#declare Ball=" + object(depth);
        case 28:
            return choice(2) ? "#declare Paint=texture{pigment{rgb " + vector(1) + "}}\n"
                             : "#declare Green=rgb " + vector(2) + ";\n";
        case 19: return "Show()\n";
        case 20:
            switch (choice(6)) {
            case 0: return "#undef New\n";
            case 4:
            case 5:
                return "#write(Out,\"\\\"\"," + string(1) + (choice(2) ? "," : " ") + string(2) +
                       (choice(5) ? "" : "," + number(1)) + ",\"\\\",\")\n";
            case 1: return "#debug \"here\\n\"\n";
            case 2: return "#if(" + condition() + ")#break#end\n";
            default: return "#declare A=" + std::string(choice(2) ? "Tail(" : "(Long(") + number(1) + "));\n";
            }
        default: return declared();
        }
    }

    std::string modifiers(int depth)
    {
        static constexpr std::array kFixed = {"texture{Paint}",
                                              "finish{Shine}",
                                              "finish{phong 1}",
                                              "no_shadow ",
                                              "hollow ",
                                              "pigment{checker}",
                                              "normal{bumps .3}",
                                              "transform{Move}",
                                              "inverse ",
                                              "pigment{Green}",
                                              "texture{Tiles}",
                                              "hollow off ",
                                              "pigment{gradient x color_map{[0 Green][1 rgb B]}}",
                                              "transform Move ",
                                              "texture{Paint finish{Shine}}",
                                              "pigment{rgb 1}",
                                              "no_image ",
                                              "interior{ior 1.5}",
                                              "pigment{color Green transmit .5}",
                                              "uv_mapping "};
        std::string text;
        for (std::size_t i = choice(4); i > 0; --i) {
            switch (choice(9)) {
            case 0: text += "translate " + vector(depth); break;
            case 1: text += "rotate " + vector(depth); break;
            case 2: text += "scale " + (choice(2) ? number(2) : vector(depth)); break;
            case 3: text += std::string("pigment{") + (choice(2) ? "rgb " : "color rgbt ") + vector(2) + "}"; break;
            case 4:
                text += "texture{pigment{rgb " + vector(2) + "}" + (choice(2) ? "finish{Shine}" : "normal{dents B}") +
                        "}";
                break;
            default: text += kFixed[choice(kFixed.size())];
            }
            text += choice(6) ? " " : "\n";
        }
        return text;
    }

    std::string object(int depth)
    {
        const std::string comma = choice(4) ? "," : " ";
        const auto v = [&] { return vector(depth + 2); };
        const auto n = [&] { return number(depth + 2); };
        std::string text;
        switch (choice(depth > 3 ? 8 : 13)) {
        case 0:
        case 1: text = "sphere{" + v() + comma + n(); break;
        case 2: text = "box{" + v() + comma + v(); break;
        case 3: text = "cylinder{" + v() + comma + v() + comma + n() + (choice(2) ? " open " : " "); break;
        case 4: text = "cone{" + v() + comma + n() + comma + v() + comma + n() + (choice(2) ? " open " : " "); break;
        case 5: text = choice(2) ? "torus{" + n() + comma + n() : "plane{" + v() + comma + n(); break;
        case 6:
            text = choice(2) ? "triangle{" + v() + comma + v() + comma + v() : "triangle{<0,0,0>,<1,0,0>,<0,1,2>";
            break;
        case 7:
            text = choice(2) ? "disc{" + v() + comma + v() + comma + n() + (choice(2) ? "" : ",0.1") : "object{Ball";
            break;
        case 8:
            text = "smooth_triangle{" + v() + comma + v() + comma + v() + comma + v() + comma + v() + comma + v();
            break;
        case 9: text = "object{" + object(depth + 1); break;
        default: {
            static constexpr std::array kOperators = {"union{", "difference{", "intersection{", "merge{"};
            text = kOperators[choice(kOperators.size())];
            for (std::size_t i = 1 + choice(3); i > 0; --i)
                text += choice(6) ? object(depth + 1) : std::string("Ball ");
        }
        }
        return text + " " + modifiers(depth + 1) + "}\n";
    }

    std::string component(int depth)
    {
        const std::string tail = number(depth + 2) + (choice(2) ? "," : " strength ") + number(depth + 2) + " " +
                                 modifiers(depth + 2) + "}\n";
        switch (choice(4)) {
        case 0: return "component " + number(3) + " " + number(3) + " " + vector(3) + "\n";
        case 1: return "cylinder{" + vector(depth + 2) + "," + vector(depth + 2) + "," + tail;
        default: return "sphere{" + vector(depth + 2) + "," + tail;
        }
    }

    std::string face(int depth)
    {
        const bool smooth = choice(3) == 0;
        std::string text = smooth ? "smooth_triangle{" : "triangle{";
        for (int i = 0; i < (smooth ? 6 : 3); ++i) text += vector(depth + 2) + (choice(3) ? "," : " ");
        static constexpr std::array kTails = {"", "", "uv_vectors <0,0>,<1,0>,<A,1>", "texture{Paint}"};
        return text + kTails[choice(kTails.size())] + "}\n";
    }

    std::string condition()
    {
        static constexpr std::array kRelations = {"<", ">", "<=", ">=", "=", "!="};
        if (choice(6) == 5) return string(1) + kRelations[choice(6)] + string(1);
        return choice(4) ? number(1) + kRelations[choice(6)] + number(1) : number(0);
    }

    std::string number(int depth)
    {
        static constexpr std::array kPlain = {
            "A",     "B",   "I",   "J",    "1",           "0",         "2.5",           "X",
            "Y",     "V.x", "pi",  "3",    "L[mod(I,4)]", "Q[1][0]",   "P[mod(J,2)].z", "A",
            "K.red", "I+1", "New", "L[J]", "rand(R)",     "strlen(S)", "Curve(I).x"};
        static constexpr std::array kSigns = {"+", "-", "*", "/", "+", "-", "*", "<", ">=", "=", "!=", "&", "|"};
        static constexpr std::array kOne = {"sin", "abs", "floor", "int", "F", "-", "!", "sqrt", "radians", "F"};
        static constexpr std::array kTwo = {"max", "min", "mod", "pow", "atan2", "div"};
        static constexpr std::array kMacros = {"Tail", "Long", "Again", "Twice", "Same",
                                               "Side", "Odd",  "Both",  "Made",  "Again"};
        const std::size_t form = choice(14);
        if (form == 13 && depth < 3) {
            const std::string name = kMacros[choice(kMacros.size())];
            const std::string given = choice(3)         ? std::string(name == "Again" ? "I" : kPlain[choice(12)])
                                      : name == "Again" ? "mod(I,5)"
                                                        : number(depth + 2);
            return choice(3) ? "(" + name + "(" + given + "))" : name + "(" + given + ")";
        }
        if (depth > 3 || form < 6) return kPlain[choice(kPlain.size() - (choice(8) ? 5 : 0))];
        const auto inner = [&] { return number(depth + 1); };
        const std::string first = inner();
        switch (form) {
        case 6: return "(" + first + kSigns[choice(kSigns.size())] + inner() + ")";
        case 7: return first + kSigns[choice(choice(6) ? 3 : 4)] + inner();
        case 8: return std::string(kOne[choice(kOne.size())]) + "(" + first + ")";
        case 9: return std::string(kTwo[choice(kTwo.size())]) + "(" + first + "," + inner() + ")";
        case 10: {
            const std::string yes = inner();
            return "(" + first + "?" + yes + ":" + inner() + ")";
        }
        case 11: return choice(2) ? "vlength(" + vector(depth + 1) + ")" : "dimension_size(Q,1+mod(I,3))";
        default: {
            if (choice(2)) return "val(str(" + first + ",0,3))";
            const std::string text = string(depth + 1);
            return choice(2) ? "asc(" + text + ")" : "strcmp(" + text + "," + string(depth + 1) + ")";
        }
        }
    }

    std::string vector(int depth)
    {
        static constexpr std::array kPlain = {"V", "P[mod(I,2)]", "x", "<1,I,3>", "z"};
        const std::size_t form = choice(9);
        if (depth > 3 || form < 4) return kPlain[choice(kPlain.size())];
        const std::string first = vector(depth + 1);
        switch (form) {
        case 4: return "(" + first + (choice(2) ? "+" : "-") + vector(depth + 1) + ")";
        case 5: return number(depth + 1) + "*" + first;
        case 6: return first + "*" + number(depth + 2);
        case 7: return "vcross(" + first + "," + vector(depth + 1) + ")";
        default: {
            const std::string a = number(depth + 1), b = number(depth + 1);
            return "<" + a + "," + b + "," + number(depth + 1) + ">";
        }
        }
    }

    std::string string(int depth)
    {
        static constexpr std::array kPlain = {"S", "T[mod(I,3)]", "\"ab\"", "\"\"", "\"Z\\n\""};
        const std::size_t form = choice(8);
        if (depth > 2 || form < 3) return kPlain[choice(kPlain.size())];
        switch (form) {
        case 3: return "concat(\"q\"," + string(depth + 1) + ")";
        case 4: return "substr(concat(\"abcd\"," + string(depth + 1) + "),1+mod(I,4),1)";
        case 5: return "str(" + number(depth + 1) + ",0,3)";
        case 6: return choice(2) ? "strupr(" + string(depth + 1) + ")" : "chr(65+mod(I,9))";
        default: return "vstr(3," + vector(depth + 1) + ",\";\",0,2)";
        }
    }

    const fuzz::Bytes& bytes_;
    std::size_t at_ = 0;
};

struct Said {
    std::string text;
    bool unending = false;
};

void keep(void* said, const parser::Message& message)
{
    static_cast<Said*>(said)->text += std::to_string(static_cast<int>(message.severity)) +
                                      fuzz::without_sign_of_nan(message_text(message)) + "\n";
}

Said said_by(const std::string& text, bool blocks)
{
    Said said;
    parser::Options options;
    options.blocks = blocks;
    options.most_tokens = 100'000;
    options.write_nothing = true;  // a scene reads what it would have written
    try {
        const parser::Result result = parser::parse_text(text, "fuzz.pov", options, keep, &said);
        said.text += "read to its end\n" + fuzz::without_sign_of_nan(scene::dump(result.scene));
    } catch (const parser::Error& error) {
        said.text += error.what();
        said.unending = std::string_view(error.what()).find("the limit of tokens") != std::string_view::npos;
    }
    return said;
}

}  // namespace

void fuzz::one(const Bytes& bytes)
{
    const std::string text = Program(bytes).text();
    const Said plain = said_by(text, false), compiled = said_by(text, true);
    if (plain.unending || compiled.unending) return;  // how many tokens a block counts for is no promise
    if (plain.text != compiled.text)
        fail("compiled says otherwise than word by word:\n" + text + "\ncompiled: " + compiled.text +
             "\nword by word: " + plain.text);
}

std::vector<fuzz::Bytes> fuzz::seeds()
{
    std::vector<Bytes> all;
    for (std::uint32_t seed = 1; seed < 200; ++seed) all.push_back(noise(seed, 200 + 8 * seed));
    return all;
}
