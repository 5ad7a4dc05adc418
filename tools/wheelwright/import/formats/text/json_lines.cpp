#include "tools/wheelwright/import/formats/text/json_lines.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "tools/wheelwright/import/formats/text/line_tally.hpp"
#include "tools/wheelwright/import/formats/text/python_literal.hpp"
#include "tools/wheelwright/import/recording/recording.hpp"

namespace wheelwright::import {
namespace {

constexpr std::size_t max_depth = 24;
constexpr std::size_t max_members = 4096;
constexpr std::size_t max_streams = 256;

// Collects the numbers of one object under their flattened names. The parser calls it for each part.
class Flattener {
 public:
  using Number = std::pair<std::string, double>;
  const std::vector<Number>& numbers() const { return numbers_; }

  bool null() { return put(nothing); }
  bool boolean(bool value) { return put(value ? 1.0 : 0.0); }
  bool number_integer(std::int64_t value) { return put(static_cast<double>(value)); }
  bool number_unsigned(std::uint64_t value) { return put(static_cast<double>(value)); }
  bool number_float(double value, const std::string&) { return put(value); }
  bool string(const std::string&) {
    step();
    return true;
  }
  bool binary(const std::vector<std::uint8_t>&) { return false; }
  bool start_object(std::size_t) { return open(false); }
  bool start_array(std::size_t) { return open(true); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }
  bool key(const std::string& name) {
    path_.resize(levels_.back().path_length);
    path_ += (path_.empty() ? "" : ".") + name;
    return true;
  }
  template <typename Error>
  bool parse_error(std::size_t, const std::string&, const Error&) {
    return false;
  }

 private:
  struct Level {
    std::size_t path_length = 0;
    std::size_t index = 0;
    bool is_array = false;
  };

  void step() {
    if (levels_.empty() || !levels_.back().is_array) return;
    path_.resize(levels_.back().path_length);
    path_ += "[" + std::to_string(levels_.back().index++) + "]";
  }
  bool put(double value) {
    step();
    numbers_.emplace_back(path_, value);
    return numbers_.size() <= max_members;
  }
  bool open(bool is_array) {
    step();
    levels_.push_back({path_.size(), 0, is_array});
    return levels_.size() <= max_depth;
  }
  bool close() {
    levels_.pop_back();
    return true;
  }

  std::string path_;
  std::vector<Level> levels_;
  std::vector<Number> numbers_;
};

bool parse(std::string_view line, Flattener& flattener) {
  return nlohmann::json::sax_parse(line.begin(), line.end(), &flattener) && !flattener.numbers().empty();
}

Stream make_stream(const std::vector<Flattener::Number>& numbers) {
  Stream stream;
  for (const auto& [name, value] : numbers) stream.channels.push_back({name, {}, {}});
  return stream;
}

}  // namespace

bool are_json_lines(const TextSample& sample) {
  const auto begins_object = [](std::string_view line) {
    line = trim(line);
    return line.starts_with('{') && line.ends_with('}');
  };
  const auto count = static_cast<std::size_t>(std::ranges::count_if(sample.contents, begins_object));
  return count > 0 && 2 * count > sample.contents.size();
}

std::vector<Stream> read_json_lines(std::string_view text, std::vector<std::string>& remarks) {
  std::map<std::string, std::size_t> stream_of_form;
  std::vector<Stream> streams;
  LineTally unread;
  LineCursor cursor(text);
  Line line;
  while (cursor.next_filled(line)) {
    Flattener flattener;
    if (!parse(trim(line.text), flattener)) {
      flattener = {};
      if (!parse(json_of_python(trim(line.text)), flattener)) {
        unread.add(line);
        continue;
      }
    }
    std::string form;
    for (const auto& [name, value] : flattener.numbers()) form += name + '\n';
    const auto [found, is_new] = stream_of_form.try_emplace(form, streams.size());
    if (is_new && streams.size() == max_streams) {
      stream_of_form.erase(found);
      unread.add(line);
      continue;
    }
    if (is_new) streams.push_back(make_stream(flattener.numbers()));
    Stream& stream = streams[found->second];
    for (std::size_t i = 0; i < flattener.numbers().size(); ++i)
      stream.channels[i].values.push_back(flattener.numbers()[i].second);
    stream.places.push_back(line.number);
    ++stream.rows;
  }
  unread.say("no object with numbers, left out", remarks);
  for (std::size_t i = 0; streams.size() > 1 && i < streams.size(); ++i)
    streams[i].name = "form " + std::to_string(i + 1);
  return streams;
}

}  // namespace wheelwright::import
