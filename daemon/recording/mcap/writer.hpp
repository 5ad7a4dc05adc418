// Writes MCAP files (version 0, https://mcap.dev/spec): messages on channels, in compressed chunks, with a
// message index after each chunk and a summary at the end.
//
// The file grows chunk by chunk and is readable up to its last whole chunk at any time, so that a power cut
// costs what was in the open chunk and the summary, which readers rebuild. Chunks, the data section and the
// summary carry checksums.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wheelwright::mcap {

// Takes bytes to the end of the file, all of them or, by returning false, none.
using Sink = std::function<bool(std::string_view)>;

struct WriterOptions {
  std::size_t chunk_bytes = 1UL << 20U;  // a chunk ends by itself once it holds as much
  bool compress = true;                  // by zstd
};

class Writer {
 public:
  // Begins a file. `metadata` is kept in it as a record named "wheelwright".
  Writer(Sink sink, const std::map<std::string, std::string>& metadata, const WriterOptions& options = {});

  // A stream of JSON messages; `schema` is a JSON Schema, shared by all channels that give the same name.
  // Returns the channel's number for add().
  std::uint16_t add_channel(const std::string& topic, const std::string& schema_name,
                            const std::string& schema);

  // A message at a time in nanoseconds since any epoch.
  void add(std::uint16_t channel, std::uint64_t time_ns, std::string_view json);

  // Hands the open chunk to the sink. Where the sink refuses it, its messages are lost and counted.
  void end_chunk();

  // Ends the file; nothing may be added after that. False where the sink refused the end: then the file
  // lacks its summary.
  bool finish();

  std::uint64_t lost_messages() const { return lost_messages_; }

 private:
  struct Schema {
    std::string name;
    std::string record;
    std::optional<std::uint64_t> declared_in;  // number of the chunk
  };
  struct Channel {
    std::uint16_t schema = 0;  // index into schemas_
    std::string record;
    std::optional<std::uint64_t> declared_in;  // number of the chunk
    std::uint32_t messages = 0;
    std::string index;  // of the open chunk: pairs of time and offset
    std::uint64_t kept_messages = 0;
  };
  struct TimeSpan {
    std::uint64_t first_ns = 0;
    std::uint64_t last_ns = 0;
    bool empty = true;
    void include(std::uint64_t time_ns);
    void include(const TimeSpan& other);
  };

  struct Stored {  // the open chunk as it goes into the file
    std::string_view compression;
    const std::string& bytes;
  };

  bool give(std::string_view bytes);
  void declare(Channel& channel);
  std::string chunk_record(const Stored& stored) const;
  std::string add_message_indexes(const Stored& stored, std::string& block) const;
  std::string summary(std::uint64_t start) const;
  std::string statistics() const;

  Sink sink_;
  WriterOptions options_;
  std::vector<Schema> schemas_;
  std::vector<Channel> channels_;
  std::string metadata_index_;
  std::string open_chunk_;
  std::string chunk_indexes_;  // records, for the summary
  TimeSpan chunk_span_;
  TimeSpan file_span_;
  std::uint64_t chunk_number_ = 0;  // of the open one, those that were refused included
  std::uint64_t chunk_messages_ = 0;
  std::uint32_t chunks_ = 0;
  std::uint64_t offset_ = 0;  // end of the file
  std::uint32_t crc_ = 0;     // of the file so far
  std::uint64_t lost_messages_ = 0;
};

}  // namespace wheelwright::mcap
