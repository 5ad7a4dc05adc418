// wheelwright inspect: what a file holds, and what it would be taken for.
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>
#include <sstream>
#include <utility>

#include "config/load/printable_text.hpp"
#include "config/load/text_format.hpp"
#include "model/statistics/order_statistics.hpp"
#include "tools/wheelwright/common/commands.hpp"
#include "tools/wheelwright/common/json_text.hpp"
#include "tools/wheelwright/import/conversion/stream_time.hpp"
#include "tools/wheelwright/import/import_files.hpp"
#include "tools/wheelwright/logs/log_checks.hpp"
#include "tools/wheelwright/logs/log_input.hpp"

namespace wheelwright::tools {
namespace {

using config::fixed_number;
using config::printable;
using nlohmann::ordered_json;

struct InspectOptions {
  std::vector<std::string> files;
  std::string reference;
  ImportOptions import;
  bool json = false;
};

// How far the rows of a stream are apart.
struct Steps {
  double p5_s = 0.0;
  double median_s = 0.0;
  double p95_s = 0.0;
  double longest_s = 0.0;
};

std::optional<Steps> steps_of(const import::Stream& stream, const import::TimeMapping& time) {
  const auto t_s = import::stream_times(stream, time);
  std::vector<double> steps;
  for (std::size_t i = 1; i < t_s.size(); ++i) {
    if (t_s[i] > t_s[i - 1]) steps.push_back(t_s[i] - t_s[i - 1]);
  }
  if (steps.empty()) return std::nullopt;
  const auto at = [&](double share) { return quantile(steps, share); };
  return Steps{at(0.05), at(0.5), at(0.95), std::ranges::max(steps)};
}

struct ChannelSummary {
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -std::numeric_limits<double>::infinity();
  std::size_t missing = 0;
  bool whole = true;
};

ChannelSummary summarise(const import::Channel& channel) {
  ChannelSummary summary;
  for (const double value : channel.values) {
    if (!std::isfinite(value)) {
      ++summary.missing;
      continue;
    }
    summary.lowest = std::min(summary.lowest, value);
    summary.highest = std::max(summary.highest, value);
    summary.whole = summary.whole && value == std::round(value);
  }
  return summary;
}

// The keys of the mapping that name the channel: "wheels.left".
std::string taken_for(const import::Stream& stream, const import::Channel& channel,
                      const std::vector<import::MappingEntry>& entries) {
  std::string text;
  const import::ChannelName full{stream.name, channel.name};
  for (const auto& entry : entries) {
    if (entry.value != full.text() && !(entry.key == "time.column" && entry.value == channel.name)) continue;
    if (entry.key.ends_with("unit") || entry.key.ends_with("kind")) continue;
    text += (text.empty() ? "" : ", ") + entry.key;
  }
  return text;
}

// Six figures; times of the day and since 1970 with milliseconds.
std::string short_number(double value) {
  std::ostringstream text;
  text << std::setprecision(std::abs(value) > 1e8 ? 13 : 6) << value;
  return text.str();
}

std::string milliseconds(double seconds) {
  return fixed_number(1e3 * seconds, seconds < 0.01 ? 2 : 1);
}

void print_stream(std::ostream& out, const import::Stream& stream, const import::Understood& understood) {
  out << "  " << (stream.name.empty() ? "table" : printable(stream.name));
  if (!stream.type.empty()) out << "  " << printable(stream.type);
  out << "  " << stream.rows << " rows";
  if (const auto steps = steps_of(stream, understood.mapping.time)) {
    out << ", " << milliseconds(steps->median_s) << " ms apart (5 %: " << milliseconds(steps->p5_s)
        << ", 95 %: " << milliseconds(steps->p95_s) << ", longest " << milliseconds(steps->longest_s) << ")";
  }
  out << "\n";
  if (!stream.not_decoded.empty()) out << "      not decoded: " << printable(stream.not_decoded) << "\n";
  for (const auto& channel : stream.channels) {
    const ChannelSummary summary = summarise(channel);
    std::string range = summary.lowest > summary.highest
                            ? "no number"
                            : short_number(summary.lowest) + " to " + short_number(summary.highest);
    if (summary.whole && summary.lowest < summary.highest) range += ", whole";
    if (summary.missing > 0) range += ", " + std::to_string(summary.missing) + " missing";
    out << "      " << std::left << std::setw(24)
        << printable(channel.name + (channel.unit.empty() ? "" : " [" + channel.unit + "]")) << " "
        << std::setw(34) << range;
    const std::string use = taken_for(stream, channel, understood.inference.entries);
    if (!use.empty()) out << " -> " << use;
    out << "\n";
  }
}

// One argument for a shell.
std::string shell_word(const std::string& text) {
  constexpr std::string_view safe = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./:=+-";
  if (!text.empty() && text.find_first_not_of(safe) == std::string::npos) return text;
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::string import_line(const InspectOptions& options) {
  std::string line = "wheelwright import";
  for (const auto& file : options.files) line += " " + shell_word(file);
  if (!options.reference.empty()) line += " --reference " + shell_word(options.reference);
  if (!options.import.mapping.empty()) line += " --mapping " + shell_word(options.import.mapping);
  for (const auto& setting : options.import.settings) line += " --set " + shell_word(setting);
  return line + " -o LOG.csv";
}

void print(std::ostream& out, const InspectOptions& options, const import::Understood& understood,
           const tl::expected<import::Conversion, std::string>& conversion) {
  for (const auto& recording : understood.recordings) {
    out << printable(recording.name) << ": " << printable(recording.format) << "\n";
    for (const auto& stream : recording.streams) print_stream(out, stream, understood);
    for (const auto& remark : recording.remarks) out << "  note: " << printable(remark) << "\n";
  }
  for (const auto& finding : understood.inference.findings) out << "found: " << printable(finding) << "\n";
  for (const auto& doubt : understood.inference.doubts) out << "doubt: " << printable(doubt) << "\n";
  if (!understood.inference.entries.empty()) out << "mapping:\n";
  for (const auto& entry : understood.inference.entries)
    out << "  " << entry.key << ": " << printable(entry.value) << "\n";
  if (!conversion) {
    out << "missing: " << printable(conversion.error()) << "\n";
    return;
  }
  for (const auto& remark : conversion->remarks) out << "note: " << printable(remark) << "\n";
  for (const auto& line : describe_contradictions(conversion->runs))
    out << "doubt: " << printable(line) << "\n";
  out << "import: " << import_line(options) << "\n";
}

ordered_json to_json(const import::Stream& stream, const import::Understood& understood) {
  ordered_json json{{"name", stream.name}, {"type", stream.type}, {"rows", stream.rows}};
  if (const auto steps = steps_of(stream, understood.mapping.time)) {
    json["period_s"] = {{"p5", steps->p5_s},
                        {"median", steps->median_s},
                        {"p95", steps->p95_s},
                        {"longest", steps->longest_s}};
  }
  if (!stream.not_decoded.empty()) json["not_decoded"] = stream.not_decoded;
  json["channels"] = ordered_json::array();
  for (const auto& channel : stream.channels) {
    const ChannelSummary summary = summarise(channel);
    ordered_json entry{{"name", channel.name}, {"unit", channel.unit}, {"missing", summary.missing}};
    if (summary.lowest <= summary.highest) entry["range"] = {summary.lowest, summary.highest};
    entry["taken_for"] = taken_for(stream, channel, understood.inference.entries);
    json["channels"].push_back(std::move(entry));
  }
  return json;
}

ordered_json to_json(const InspectOptions& options, const import::Understood& understood,
                     const tl::expected<import::Conversion, std::string>& conversion) {
  ordered_json json{{"importable", conversion.has_value()}, {"files", ordered_json::array()}};
  for (const auto& recording : understood.recordings) {
    ordered_json file{{"name", recording.name},
                      {"format", recording.format},
                      {"streams", ordered_json::array()},
                      {"notes", recording.remarks}};
    for (const auto& stream : recording.streams) file["streams"].push_back(to_json(stream, understood));
    json["files"].push_back(std::move(file));
  }
  json["found"] = understood.inference.findings;
  json["doubts"] = understood.inference.doubts;
  json["mapping"] = ordered_json::object();
  for (const auto& entry : understood.inference.entries) json["mapping"][entry.key] = entry.value;
  if (conversion) {
    json["notes"] = conversion->remarks;
    json["runs"] = ordered_json::array();
    for (const auto& run : conversion->runs) {
      json["runs"].push_back({{"first_line", run.first_line},
                              {"rows", run.samples.size()},
                              {"duration_s", run.samples.back().t_s},
                              {"period_s", run.period_s}});
    }
    for (const auto& line : describe_contradictions(conversion->runs)) json["doubts"].push_back(line);
    json["import"] = import_line(options);
  } else {
    json["missing"] = conversion.error();
  }
  return json;
}

ExitStatus run_inspect(const InspectOptions& options, Streams streams) {
  import::ImportRequest request{{options.files.begin(), options.files.end()},
                                std::nullopt,
                                { options.import.mapping,
                                  options.import.settings }};
  if (!options.reference.empty()) request.reference = options.reference;
  const auto understood = import::understand(request);
  if (!understood) throw UsageError(understood.error());
  const auto conversion = import::to_runs(*understood);
  if (options.json) {
    streams.out << json_text(to_json(options, *understood, conversion)) << "\n";
  } else {
    print(streams.out, options, *understood, conversion);
  }
  return conversion ? ExitStatus::done : ExitStatus::answer_is_no;
}

}  // namespace

Action add_inspect(CLI::App& app) {
  const auto options = std::make_shared<InspectOptions>();
  CLI::App* command = app.add_subcommand(
      "inspect", "What a log holds: streams, columns, rates, units, and what they are taken for");
  command
      ->add_option("FILE", options->files, "CSV and other text, ROS 1 and ROS 2 bags, MATLAB files, WPILOG")
      ->required();
  command->add_option("--reference", options->reference,
                      "File of poses from outside, with a clock of its own");
  add_import_options(*command, options->import);
  command->add_flag("--json", options->json, "The same as JSON");
  command->footer(
      "Exit status: 0 it can be imported, 1 something has to be given (it says what), 2 bad usage or no "
      "readable file.\n"
      "Example: wheelwright inspect drive.bag --set robot.wheel_base_m=0.287");
  return [options](Streams streams) { return run_inspect(*options, streams); };
}

}  // namespace wheelwright::tools
