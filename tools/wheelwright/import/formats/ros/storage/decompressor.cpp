#include "tools/wheelwright/import/formats/ros/storage/decompressor.hpp"

#include <bzlib.h>
#include <lz4frame.h>
#include <zstd.h>

#include <algorithm>
#include <cstddef>

namespace wheelwright::import::ros {
namespace {

constexpr std::uint64_t first_guess_bytes = 256U << 10U;
constexpr std::string_view cut_short = "its compressed data are cut short";

enum class Progress { goes_on, ended, damaged };

// One step of a decompressor: takes from `input`, writes to `output`, and shortens both by what it used.
struct Step {
  std::string_view& input;
  char*& output;
  std::size_t& room;

  void used(std::size_t taken, std::size_t written) const {
    input.remove_prefix(taken);
    output += written;
    room -= written;
  }
};

class Zstd {
 public:
  Zstd() : stream_(ZSTD_createDCtx()) {}
  Zstd(const Zstd&) = delete;
  Zstd& operator=(const Zstd&) = delete;
  ~Zstd() { ZSTD_freeDCtx(stream_); }
  Progress step(const Step& step) {
    ZSTD_inBuffer input{step.input.data(), step.input.size(), 0};
    ZSTD_outBuffer output{step.output, step.room, 0};
    const std::size_t result = ZSTD_decompressStream(stream_, &output, &input);
    step.used(input.pos, output.pos);
    if (ZSTD_isError(result) != 0U) return Progress::damaged;
    return result == 0 && step.input.empty() ? Progress::ended : Progress::goes_on;
  }

 private:
  ZSTD_DCtx* stream_;
};

class Lz4 {
 public:
  Lz4() { LZ4F_createDecompressionContext(&stream_, LZ4F_VERSION); }
  Lz4(const Lz4&) = delete;
  Lz4& operator=(const Lz4&) = delete;
  ~Lz4() { LZ4F_freeDecompressionContext(stream_); }
  Progress step(const Step& step) {
    std::size_t taken = step.input.size();
    std::size_t written = step.room;
    const std::size_t result =
        LZ4F_decompress(stream_, step.output, &written, step.input.data(), &taken, nullptr);
    if (LZ4F_isError(result) != 0U) return Progress::damaged;
    step.used(taken, written);
    return result == 0 && step.input.empty() ? Progress::ended : Progress::goes_on;
  }

 private:
  LZ4F_dctx* stream_ = nullptr;
};

class Bzip2 {
 public:
  Bzip2() : ready_(BZ2_bzDecompressInit(&stream_, 0, 0) == BZ_OK) {}
  Bzip2(const Bzip2&) = delete;
  Bzip2& operator=(const Bzip2&) = delete;
  ~Bzip2() {
    if (ready_) BZ2_bzDecompressEnd(&stream_);
  }
  Progress step(const Step& step) {
    if (!ready_) return Progress::damaged;
    constexpr std::size_t most = 1U << 30U;  // its counters have 32 bits
    const std::size_t offered = std::min(step.input.size(), most);
    const std::size_t room = std::min(step.room, most);
    stream_.next_in = const_cast<char*>(step.input.data());  // which it does not write to
    stream_.avail_in = static_cast<unsigned>(offered);
    stream_.next_out = step.output;
    stream_.avail_out = static_cast<unsigned>(room);
    const int result = BZ2_bzDecompress(&stream_);
    step.used(offered - stream_.avail_in, room - stream_.avail_out);
    if (result == BZ_STREAM_END) return Progress::ended;
    return result == BZ_OK ? Progress::goes_on : Progress::damaged;
  }

 private:
  bz_stream stream_{};
  bool ready_;
};

template <typename Stream>
Unpacked run(std::vector<char>& buffer, std::string_view input, std::uint64_t limit) {
  Stream stream;
  std::size_t filled = 0;
  const auto result = [&](std::string_view fault) {
    return Unpacked{{buffer.data(), filled}, std::string(fault)};
  };
  while (filled < limit) {
    if (filled == buffer.size()) {  // grows as bytes come, whatever size the file announces
      buffer.resize(std::min(limit, std::max<std::uint64_t>({2 * filled, first_guess_bytes, input.size()})));
    }
    char* output = buffer.data() + filled;
    std::size_t room = std::min<std::uint64_t>(buffer.size(), limit) - filled;
    const std::size_t input_before = input.size();
    const std::size_t room_before = room;
    const Progress progress = stream.step({input, output, room});
    filled += room_before - room;
    if (progress == Progress::damaged) return result("its compressed data are damaged");
    if (progress == Progress::ended) break;
    if (input.size() == input_before && room == room_before) return result(cut_short);
  }
  return result("");
}

}  // namespace

std::optional<Compression> compression_named(std::string_view name) {
  if (name.empty() || name == "none") return Compression::none;
  if (name == "bz2") return Compression::bz2;
  if (name == "lz4") return Compression::lz4;
  if (name == "zstd") return Compression::zstd;
  return std::nullopt;
}

bool is_zstd(std::string_view head) {
  return head.starts_with("\x28\xb5\x2f\xfd");
}

Unpacked Decompressor::unpack(Compression compression, std::string_view packed, std::uint64_t announced) {
  if (compression == Compression::none)
    return {packed, packed.size() < announced ? std::string(cut_short) : ""};
  if (announced > max_unpacked_bytes) {
    return {
        {},
        "it unpacks to " + std::to_string(announced) + " bytes, more than the 512 MiB that a chunk may have"};
  }
  Unpacked unpacked = compression == Compression::bz2   ? run<Bzip2>(buffer_, packed, announced)
                      : compression == Compression::lz4 ? run<Lz4>(buffer_, packed, announced)
                                                        : run<Zstd>(buffer_, packed, announced);
  if (unpacked.fault.empty() && unpacked.bytes.size() < announced) unpacked.fault = cut_short;
  return unpacked;
}

Unpacked Decompressor::unpack(Compression compression, std::string_view packed) {
  if (compression == Compression::none) return {packed, ""};
  return compression == Compression::bz2   ? run<Bzip2>(buffer_, packed, max_unpacked_bytes)
         : compression == Compression::lz4 ? run<Lz4>(buffer_, packed, max_unpacked_bytes)
                                           : run<Zstd>(buffer_, packed, max_unpacked_bytes);
}

}  // namespace wheelwright::import::ros
