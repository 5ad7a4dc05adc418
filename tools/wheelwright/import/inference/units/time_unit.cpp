#include "tools/wheelwright/import/inference/units/time_unit.hpp"

#include <cmath>
#include <optional>

#include "config/load/text_format.hpp"
#include "tools/wheelwright/import/columns/column_shapes.hpp"
#include "tools/wheelwright/import/conversion/drive_columns.hpp"
#include "tools/wheelwright/import/conversion/stream_time.hpp"
#include "tools/wheelwright/import/conversion/time_units.hpp"
#include "tools/wheelwright/import/conversion/wheel_travel.hpp"
#include "tools/wheelwright/import/inference/response_rows.hpp"
#include "tools/wheelwright/import/inference/units/gain_units.hpp"
#include "tools/wheelwright/import/mapping/units.hpp"

namespace wheelwright::import {
namespace {

using config::plain_number;

struct TimeColumn {
  const Stream* stream = nullptr;
  const Channel* channel = nullptr;
};

std::optional<TimeColumn> mapped_time(std::span<const Recording> recordings, const Mapping& mapping) {
  if (!mapping.time.column) return std::nullopt;
  for (const auto& recording : recordings) {
    for (const auto& stream : recording.streams) {
      if (const Channel* channel = channel_of(stream, *mapping.time.column))
        return TimeColumn{&stream, channel};
    }
  }
  return std::nullopt;
}

// How much faster than commanded the wheels go, where commands are speeds of a known unit.
std::optional<double> speed_ratio(std::span<const Recording> recordings, const GivenMapping& given,
                                  const Mapping& mapping) {
  if (!mapping.command || !mapping.wheels || mapping.wheels->kind == WheelKind::speed) return std::nullopt;
  const CommandMapping& command = *mapping.command;
  const auto scale = wheel_scale(*mapping.wheels);
  const auto unit = find_unit(speed_units(), command.unit);
  if (!scale || command.is_duty() || !unit || unit->of_wheel || unit->of_count) return std::nullopt;
  const auto columns = gather_sample(recordings, mapping);
  if (!columns) return std::nullopt;
  constexpr double max_m_s = 3.0;
  const bool is_stated = given.says("command.unit") || command.unit != "m/s";
  if (!is_stated && largest(columns->command[0]) > max_m_s) return std::nullopt;
  constexpr double min_explained = 0.5;
  const auto rows = response_rows(*columns, mapping);
  ResponseFit best;
  for (const auto& side : rows) {
    const ResponseFit fit = fit_response(side);
    if (fit.explained > best.explained) best = fit;
    if (command.is_of_body()) break;
  }
  if (best.explained < min_explained) return std::nullopt;
  return std::abs(best.gain) * *scale / unit->in_si;
}

// Which unit is right if in another the wheels go so many times as fast as commanded.
struct UnitByWheels {
  TimeUnit taken;
  double factor;
  TimeUnit right;
};

}  // namespace

void set_time_unit(std::span<const Recording> recordings, const GivenMapping& given, Mapping& mapping,
                   std::vector<std::string>& findings) {
  const auto time = mapped_time(recordings, mapping);
  if (!time || given.says("time.unit")) return;
  mapping.time.unit = time_unit_of(*time->stream, *time->channel, mapping.time.period_s);
  if (mapping.time.unit == TimeUnit::frame) {
    if (mapping.time.period_s)
      findings.push_back("time is the number of the frame, " + plain_number(*mapping.time.period_s) +
                         " s each");
    return;
  }
  const bool is_text = mapping.time.unit == TimeUnit::hms || mapping.time.unit == TimeUnit::iso;
  const auto stated = time_unit_stated_for(*time->stream, *time->channel);
  if (is_text || stated == mapping.time.unit || (mapping.time.unit == TimeUnit::s && !stated)) return;
  findings.push_back("time is in " + std::string(in_words(mapping.time.unit)) + ", by the size of its steps" +
                     (stated ? ", not in " + std::string(in_words(*stated)) + " as its name says" : ""));
}

void infer_unit_of_time(std::span<const Recording> recordings, const GivenMapping& given, Mapping& mapping,
                        std::vector<std::string>& findings, std::vector<std::string>& doubts) {
  constexpr double fast_rows_ms = 5.0;  // logs are rarely as fast, and 20 rows a second in hundredths
  const auto time = mapped_time(recordings, mapping);
  if (!time || given.says("time.unit") || mapping.time.period_s ||
      time_unit_stated_for(*time->stream, *time->channel))
    return;
  const double ratio = speed_ratio(recordings, given, mapping).value_or(0.0);
  for (const auto& [taken, factor, right] : {UnitByWheels{TimeUnit::ms, 10.0, TimeUnit::cs},
                                             {TimeUnit::ms, 1e3, TimeUnit::s},
                                             {TimeUnit::us, 1e3, TimeUnit::ms},
                                             {TimeUnit::ns, 1e3, TimeUnit::us}}) {
    if (mapping.time.unit != taken || !is_near(ratio, factor)) continue;
    mapping.time.unit = right;
    findings.push_back("time is in " + std::string(in_words(right)) + ": in " + std::string(in_words(taken)) +
                       " the wheels would go " + plain_number(rounded_gain(ratio)) +
                       " times as fast as commanded");
    return;
  }
  const double step = step_of_ms_or_cs(time->channel->values);
  if (mapping.time.unit != TimeUnit::ms || !(step > 0.0) || step > fast_rows_ms || is_near(ratio, 1.0))
    return;
  doubts.push_back("time goes by " + plain_number(step) +
                   ", which is taken for milliseconds and may be hundredths of a second; say which: --set "
                   "time.unit=ms or time.unit=cs");
}

}  // namespace wheelwright::import
