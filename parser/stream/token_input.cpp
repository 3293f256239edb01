#include "parser/stream/token_input.h"

template struct scene::Sealed<parser::OperandKinds>;
