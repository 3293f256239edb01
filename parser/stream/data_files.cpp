#include "parser/stream/token_stream.h"

/// `#fopen` and its kin. Reading and writing data files is refused with a message, never ignored.
namespace parser {

void TokenStream::open_data_file()
{
    fail(last(), "#fopen is not available yet");
}

void TokenStream::close_data_file()
{
    raw_next();  // with anything but an open file it does nothing
}

void TokenStream::read_data()
{
    fail(last(), "#read is not available yet");
}

void TokenStream::write_data()
{
    fail(last(), "#write is not available yet");
}

}  // namespace parser
