#pragma once
/// trama: codecs for three wire formats, without heap, exceptions or global state.
///
/// The reader's tour: this file, then `<module>/format.hpp` for what each format offers, then its messages. All three
/// are used alike:
///
///     decoder.next(in)       takes bytes (can: frames) and gives one packet or error, or `need_more`; core/wire_format.hpp
///     read<format>(d, in, f) calls `f` with each of the packets and errors in `in`
///     read_ahead             as read, faster where `f` does something else for every kind of message (daisy)
///     finish, idle, tick     of a decoder: the input ended, the line fell silent, time went on
///     reset, pending         forget what is in progress; how much it is
///     counters               of a decoder: what it has seen; core/error.hpp
///
///     visit<format>(p, f)    calls `f` with the packet's typed message
///     decode<message>(p)     the packet as one certain message, or why it is none; decode_into reuses an object
///     view_as<message>(p)    single fields, without decoding the others; core/view.hpp
///     p.bytes()              the packet as it came, to be passed on (daisy, gateway)
///     validate(message)      what the document does not allow in it: field, value, allowed; core/validate.hpp, core/rule.hpp
///
///     encode(message, out)   the units written, or why none were
///     encode_unchecked       the same for what the document does not allow and the wire can carry
///
///     to_json, to_text       the message in words; print_path, text_sink, name_of: parts of it; core/print.hpp, core/sink.hpp
///     for_each_field         the names and values of a message; core/layout.hpp
///     for_each_row           the layout of its type; core/describe.hpp
///     footing(stream, from)  where a large stream may be cut (daisy, gateway), for many cores or machines
///
/// docs/using.md has a program that uses most of it.
#include "trama/can/format.hpp"
#include "trama/core/describe.hpp"
#include "trama/core/print.hpp"
#include "trama/core/view.hpp"
#include "trama/daisy/footing.hpp"
#include "trama/daisy/format.hpp"
#include "trama/gateway/footing.hpp"
#include "trama/gateway/format.hpp"
