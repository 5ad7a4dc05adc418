#include "tools/wheelwright/import/formats/text/keyed_lines.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <utility>

#include "tools/wheelwright/import/formats/text/keyed_line.hpp"
#include "tools/wheelwright/import/formats/text/line_tally.hpp"
#include "tools/wheelwright/import/formats/text/row_splitter.hpp"

namespace wheelwright::import {
namespace {

constexpr std::size_t max_forms = 256;
constexpr std::size_t rare_divisor = 100;  // a form with fewer lines than this part of the most frequent one

std::string unique_name(const std::string& name, std::set<std::string>& taken) {
  std::string unique = name;
  for (std::size_t count = 2; !taken.insert(unique).second; ++count)
    unique = name + "." + std::to_string(count);
  return unique;
}

// All lines of one form.
struct Form {
  Stream stream;
  std::string words;  // all of them, for a name where no word stands alone
  std::string first_text;
  std::size_t first_line = 0;

  explicit Form(const KeyedLine& line) {
    std::set<std::string> taken;
    if (line.stamp())
      stream.channels.push_back({unique_name("stamp", taken), std::string(line.stamp_unit()), {}});
    const auto& all = line.words();
    const bool has_key = all.size() == 1 || all.front().numbers == 0;
    if (has_key) stream.name = all.front().text;
    for (const KeyedWord& word : all) {
      words += (words.empty() ? "" : ",") + std::string(word.text);
      for (std::size_t i = 0; i < word.numbers; ++i) {
        std::string name(word.text);
        if (word.numbers > 1) name = (all.size() == 1 ? "" : name + ".") + std::to_string(i + 1);
        stream.channels.push_back({unique_name(name, taken), std::string(word.unit), {}});
      }
    }
  }

  void add(const KeyedLine& line, std::size_t number) {
    std::size_t column = 0;
    if (line.stamp()) stream.channels[column++].values.push_back(*line.stamp());
    for (const double value : line.values()) stream.channels[column++].values.push_back(value);
    stream.places.push_back(number);
    ++stream.rows;
  }
};

class KeyedReader {
 public:
  void take(const Line& line) {
    if (!parsed_.parse(line.text)) {
      unread_.add(line);
      return;
    }
    auto found = forms_.find(parsed_.form());
    if (found == forms_.end()) {
      if (forms_.size() == max_forms) {
        unread_.add(line);
        return;
      }
      found = forms_.emplace(parsed_.form(), Form(parsed_)).first;
      found->second.first_line = line.number;
      found->second.first_text = line.text.substr(0, 200);
    }
    if (line.is_open_ended) last_ = &found->second;
    found->second.add(parsed_, line.number);
  }

  std::vector<Stream> finish(std::vector<std::string>& remarks) {
    std::size_t most = 0;
    for (const auto& [key, form] : forms_) most = std::max(most, form.stream.rows);
    const std::size_t fewest = std::max<std::size_t>(2, most / rare_divisor);
    std::vector<Form*> kept;
    for (auto& [key, form] : forms_) {
      if (form.stream.rows >= fewest) {
        kept.push_back(&form);
      } else {
        say_rare(form, remarks);
      }
    }
    std::ranges::sort(kept, {}, &Form::first_line);
    unread_.say("text without a word and its numbers, left out", remarks);
    if (rare_forms_ > max_rare_remarks)
      remarks.push_back(std::to_string(rare_forms_ - max_rare_remarks) +
                        " more forms of line that hardly occur: left out");
    return name_streams(kept, remarks);
  }

 private:
  static constexpr std::size_t max_rare_remarks = 8;

  void say_rare(const Form& form, std::vector<std::string>& remarks) {
    if (++rare_forms_ > max_rare_remarks) return;
    LineTally tally;
    for (std::size_t i = 0; i < form.stream.rows; ++i) tally.add(form.first_line, form.first_text);
    tally.say("text, or a row that was cut: no other lines are like it, left out", remarks);
  }

  std::vector<Stream> name_streams(const std::vector<Form*>& kept, std::vector<std::string>& remarks) const {
    std::vector<Stream> streams;
    std::set<std::string> taken;
    for (Form* form : kept) {
      if (form->stream.name.empty() && kept.size() > 1) form->stream.name = form->words;
      form->stream.name = unique_name(form->stream.name, taken);
      if (form == last_)
        remarks.push_back("line " + std::to_string(form->stream.places.back()) +
                          ": the last line has no line break; its last number may be cut short");
      streams.push_back(std::move(form->stream));
    }
    return streams;
  }

  KeyedLine parsed_;
  std::map<std::string, Form> forms_;
  const Form* last_ = nullptr;  // of the line that ends the text without a line break
  LineTally unread_;
  std::size_t rare_forms_ = 0;
};

}  // namespace

double share_of_keyed_lines(const TextSample& sample) {
  std::map<std::string, std::size_t> forms;
  KeyedLine parsed;
  for (const std::string_view line : sample.contents) {
    if (parsed.parse(line)) ++forms[parsed.form()];
  }
  std::size_t keyed = 0;
  for (const auto& [form, lines] : forms) keyed += lines > 1 ? lines : 0;
  return sample.contents.empty() ? 0.0
                                 : static_cast<double>(keyed) / static_cast<double>(sample.contents.size());
}

bool are_assignments(const TextSample& sample) {
  constexpr double nearly_all = 0.9;
  const auto holds_two = [](std::string_view line) {
    std::size_t count = 0;
    for (std::size_t at = 1; at + 1 < line.size(); ++at) {
      const bool behind_word = std::isalpha(static_cast<unsigned char>(line[at - 1])) != 0 ||
                               std::isdigit(static_cast<unsigned char>(line[at - 1])) != 0 ||
                               line[at - 1] == '_';
      if (line[at] == '=' && behind_word &&
          std::string_view("0123456789+-.").find(line[at + 1]) != std::string_view::npos)
        ++count;
    }
    return count >= 2;
  };
  const auto held = static_cast<double>(std::ranges::count_if(sample.contents, holds_two));
  return !sample.contents.empty() && held >= nearly_all * static_cast<double>(sample.contents.size());
}

std::vector<Stream> read_keyed_lines(std::string_view text, std::vector<std::string>& remarks) {
  KeyedReader reader;
  LineCursor cursor(text);
  Line line;
  while (cursor.next_filled(line)) reader.take(line);
  return reader.finish(remarks);
}

}  // namespace wheelwright::import
