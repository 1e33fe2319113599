#pragma once
/// trama: codecs for three wire formats, without heap, exceptions or global state.
///
/// The reader's tour: this file, then `<module>/format.hpp` for what each format offers, then its messages. All three
/// are used alike:
///
///     decoder.next(in)       takes bytes (can: frames) and gives one packet or error, or `need_more`
///     visit<format>(p, f)    calls `f` with the packet's typed message
///     decode<message>(p)     the packet as one certain message, or why it is none
///     validate(message)      what the document does not allow in it
///     encode(message, out)   the units written, or why none were
///     view_as<message>(p)    single fields, without decoding the others
///     to_json, to_text       the message in words
///     footing(stream, from)  where a large stream may be cut (daisy, gateway), for many cores or machines
#include "trama/can/format.hpp"
#include "trama/core/describe.hpp"
#include "trama/core/view.hpp"
#include "trama/daisy/footing.hpp"
#include "trama/daisy/format.hpp"
#include "trama/gateway/footing.hpp"
#include "trama/gateway/format.hpp"
