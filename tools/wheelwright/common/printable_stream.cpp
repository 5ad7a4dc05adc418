#include "tools/wheelwright/common/printable_stream.hpp"

#include "config/load/printable_text.hpp"

namespace wheelwright::tools {

PrintableStream::PrintableStream(std::ostream& target) : std::ostream(nullptr), buffer_(target) {
  rdbuf(&buffer_);
}

PrintableStream::~PrintableStream() {
  flush();
}

PrintableStream::Buffer::int_type PrintableStream::Buffer::overflow(int_type character) {
  if (traits_type::eq_int_type(character, traits_type::eof())) return traits_type::not_eof(character);
  const char one = traits_type::to_char_type(character);
  return xsputn(&one, 1) == 1 ? character : traits_type::eof();
}

std::streamsize PrintableStream::Buffer::xsputn(const char* text, std::streamsize size) {
  const std::size_t before = held_.size();
  held_.append(text, static_cast<std::size_t>(size));
  const auto line_end = held_.rfind('\n');
  if (line_end != std::string::npos && line_end >= before) pass_on(line_end + 1);
  return target_ ? size : 0;
}

int PrintableStream::Buffer::sync() {
  pass_on(held_.size());
  target_.flush();
  return target_ ? 0 : -1;
}

void PrintableStream::Buffer::put_as_it_is(std::string_view text) {
  pass_on(held_.size());
  target_ << text;
}

void PrintableStream::Buffer::pass_on(std::size_t size) {
  target_ << config::printable_lines(std::string_view(held_).substr(0, size));
  held_.erase(0, size);
}

void put_escape_sequence(std::ostream& out, std::string_view sequence) {
  if (auto* printable = dynamic_cast<PrintableStream*>(&out)) {
    printable->buffer_.put_as_it_is(sequence);
  } else {
    out << sequence;
  }
}

}  // namespace wheelwright::tools
