// What a command prints, made fit for a terminal: text of others can neither move the cursor nor change a
// colour there, whichever command prints it.
#pragma once

#include <ostream>
#include <streambuf>
#include <string>
#include <string_view>

namespace wheelwright::tools {

// Passes whole lines on to `target`, the rest when it is flushed or ends.
class PrintableStream : public std::ostream {
 public:
  explicit PrintableStream(std::ostream& target);
  PrintableStream(const PrintableStream&) = delete;
  PrintableStream& operator=(const PrintableStream&) = delete;
  ~PrintableStream() override;

 private:
  friend void put_escape_sequence(std::ostream& out, std::string_view sequence);

  class Buffer : public std::streambuf {
   public:
    explicit Buffer(std::ostream& target) : target_(target) {}
    void put_as_it_is(std::string_view text);

   protected:
    int_type overflow(int_type character) override;
    std::streamsize xsputn(const char* text, std::streamsize size) override;
    int sync() override;

   private:
    void pass_on(std::size_t size);
    std::ostream& target_;
    std::string held_;
  };
  Buffer buffer_;
};

// A colour of the program's own, which goes through a PrintableStream as it is.
void put_escape_sequence(std::ostream& out, std::string_view sequence);

}  // namespace wheelwright::tools
