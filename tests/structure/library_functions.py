#!/usr/bin/python3
"""Nothing that a picture depends on asks the C library for a function that it picks by the processor: numbers/functions has them.

usage: library_functions.py [ROOT]
"""
import pathlib
import re
import sys

# Those that are exact (sqrt, fma, fmod, floor, ldexp, ilogb, ...) are the same everywhere.
NAMES = "|".join("sin cos tan asin acos atan atan2 sincos exp exp2 exp10 expm1 log log2 log10 log1p pow sinh cosh tanh asinh acosh atanh "
                 "cbrt hypot erf erfc lgamma tgamma".split())
CALLED = re.compile(rf"\b(?:std|glm)::(?:{NAMES})[fl]?\b(?!::)|(?<![\w:.>])(?:pow|(?:{NAMES})f)(?=\()")
# Reports, measures and words for people: no picture depends on them.
TOOLS = ("language/", "render/app/solid/", "render/image/compare/", "render/solid/", "render/study/")


def called_in(text):
    """(line, call) of each in C++ text; comments may say what they like."""
    for number, line in enumerate(text.splitlines(), 1):
        for match in CALLED.finditer(line.split("//")[0]):
            yield number, match[0]


def main():
    probe = ("a = std::sin(b);\nnumbers::sin(b); std::numbers::pi; // std::exp(1)\n"
             "glm::cos(v); std::pow(x, y); std::sqrt(x); std::expm1(x)\npow(a, b); x.pow(a);")
    if [call for _, call in called_in(probe)] != ["std::sin", "glm::cos", "std::pow", "std::expm1", "pow"]:
        sys.exit(f"library_functions.py finds wrongly: {list(called_in(probe))}")
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parents[2]).resolve()
    read, wrong, by_tools = 0, 0, set()
    for folder in ("numbers", "csg", "function", "language", "parser", "render"):
        for path in sorted((root / folder).rglob("*")):
            name = str(path.relative_to(root))
            if path.suffix not in {".h", ".cpp", ".inc"} or name.startswith("numbers/functions/"):
                continue
            read += 1
            tool = next((t for t in TOOLS if name.startswith(t)), None)
            for line, call in called_in(path.read_text()):
                if tool:
                    by_tools.add(tool)
                    continue
                print(f"{name}:{line}: {call} is the C library's; numbers/functions/functions.h has one for every machine")
                wrong += 1
    for tool in sorted(set(TOOLS) - by_tools):
        print(f"{tool} asks none and needs no exception")
        wrong += 1
    print(f"{read} files, {wrong} faults")
    return 1 if wrong or read < 500 else 0


if __name__ == "__main__":
    sys.exit(main())
