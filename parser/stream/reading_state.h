#pragma once

#include "parser/lexer/token.h"
#include "parser/stream/values/symbols.h"
#include "render/scene/base/source_ref.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

/// What a TokenStream keeps of the texts, directives and blocks that it is in the middle of.
namespace parser {

inline const Token kNoToken;

/// Sets a flag until the end of the scope.
class FlagInScope {
public:
    FlagInScope(bool& flag, bool wanted) : flag_(flag), before_(flag) { flag = wanted; }
    ~FlagInScope() { flag_ = before_; }
    FlagInScope(const FlagInScope&) = delete;
    FlagInScope& operator=(const FlagInScope&) = delete;
    bool before() const { return before_; }

private:
    bool& flag_;
    const bool before_;
};

/// A text that is being read, whole or the part that is a macro's body.
struct Cursor {
    std::uint16_t file = 0;
    bool macro = false;      ///< else a whole text
    std::uint32_t name = 0;  ///< of the macro
    std::uint32_t position = 0, end = 0;
    const Token* tokens = nullptr;   ///< of the file
    std::uint32_t* sites = nullptr;  ///< of the file, once asked for
    std::size_t blocks = 0;          ///< blocks open when it was entered
    const Token* call = &kNoToken;   ///< where the macro was called or the file included
};

enum class BlockKind : std::uint8_t { If, Switch, While, For, Macro };

/// A directive whose `#end` is still to come.
struct Block {
    BlockKind kind = BlockKind::If;
    bool repeats = false;  ///< its text may be read again: a loop or macro, or in one
    std::uint16_t file = 0;
    std::uint32_t branch = 0;    ///< Hash of the branch that is being read
    std::uint32_t again = 0;     ///< While: token of its condition; For: first token of the body
    std::size_t cursors = 0;     ///< depth of the cursor it began in
    Cell variable;               ///< For
    double limit = 0, step = 0;  ///< For
};

/// What the left side of a declaration names.
struct DeclarationTarget {
    Token name;
    bool known = false;                  ///< the name means something already
    Cell element;                        ///< the element or member that is written; null: the name itself
    std::shared_ptr<Array> array;        ///< that holds the element
    bool global = false, local = false;  ///< `global.` or `local.` stood before the name
};

/// A warning about a block of the grammar that waits until the block is closed: an error in it would be the cause.
struct BlockWarning {
    std::size_t depth;  ///< how many blocks were open, that one included
    scene::SourceRef at;
    std::string text;
};

}  // namespace parser
