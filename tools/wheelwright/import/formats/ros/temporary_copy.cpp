#include "tools/wheelwright/import/formats/ros/temporary_copy.hpp"

#include <stdlib.h>
#include <unistd.h>
#include <zstd.h>

#include <cstdint>
#include <cstdio>
#include <memory>
#include <utility>
#include <vector>

#include "tools/wheelwright/import/formats/ros/storage/file_bytes.hpp"

namespace wheelwright::import::ros {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

struct FreeStream {
  void operator()(ZSTD_DCtx* stream) const { ZSTD_freeDCtx(stream); }
};

struct Outcome {
  std::string refusal;  // nothing can be read
  std::string fault;    // the rest cannot be read
};

// A small file may stand for more than any disk holds: half of what is free may be used.
Outcome unpack_to(std::FILE* output, FileBytes& input, std::uintmax_t max_bytes) {
  constexpr std::uint64_t piece_bytes = 1U << 20U;
  std::unique_ptr<ZSTD_DCtx, FreeStream> stream(ZSTD_createDCtx());
  std::vector<char> piece(piece_bytes);
  std::uintmax_t written = 0;
  std::size_t wanted = 0;
  for (std::uint64_t place = 0; place < input.size(); place += piece_bytes) {
    const std::string_view packed = input.view(place, piece_bytes);
    ZSTD_inBuffer in{packed.data(), packed.size(), 0};
    bool may_hold_more = false;
    do {
      ZSTD_outBuffer out{piece.data(), piece.size(), 0};
      wanted = ZSTD_decompressStream(stream.get(), &out, &in);
      if (std::fwrite(piece.data(), 1, out.pos, output) != out.pos)
        return {"does not fit, unpacked, into the folder for temporary files; unpack it with zstd -d", ""};
      if (ZSTD_isError(wanted) != 0U)
        return {"", "its compressed data are damaged: what is before the fault is read"};
      written += out.pos;
      if (written > max_bytes)
        return {
            "unpacks to more than half of what is free in the folder for temporary files; unpack it with "
            "zstd -d",
            ""};
      may_hold_more = in.pos < in.size || out.pos == out.size;
    } while (may_hold_more);
  }
  return {"", wanted == 0 ? "" : "its compressed data are cut short: what is before the cut is read"};
}

}  // namespace

tl::expected<TemporaryCopy, std::string> TemporaryCopy::unpack(const std::filesystem::path& packed) {
  auto input = FileBytes::open(packed);
  if (!input) return tl::unexpected(input.error());
  const auto refused = [&](const std::string& why) { return tl::unexpected(packed.string() + ": " + why); };
  std::error_code error;
  const std::filesystem::path folder = std::filesystem::temp_directory_path(error);
  std::string name = (folder / "wheelwright_import_XXXXXX").string();
  const int descriptor = error ? -1 : ::mkstemp(name.data());
  if (descriptor < 0) return refused("cannot be unpacked: the folder for temporary files takes no file");
  TemporaryCopy copy{std::filesystem::path(name)};
  const File output(::fdopen(descriptor, "wb"));
  const auto space = std::filesystem::space(folder, error);
  Outcome outcome = unpack_to(output.get(), *input, error ? 0 : space.available / 2);
  if (outcome.refusal.empty() && std::fflush(output.get()) != 0)
    outcome.refusal = "does not fit, unpacked, into the folder for temporary files; unpack it with zstd -d";
  if (!outcome.refusal.empty()) return refused(outcome.refusal);
  copy.fault_ = std::move(outcome.fault);
  return copy;
}

TemporaryCopy::TemporaryCopy(TemporaryCopy&& other) noexcept
    : path_(std::exchange(other.path_, {})), fault_(std::move(other.fault_)) {}

TemporaryCopy::~TemporaryCopy() {
  std::error_code ignored;
  if (!path_.empty()) std::filesystem::remove(path_, ignored);
}

}  // namespace wheelwright::import::ros
