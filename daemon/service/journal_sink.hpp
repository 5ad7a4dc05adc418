// The daemon's messages as journal entries with fields, so that one robot, or one run, can be picked out:
// `journalctl WHEELWRIGHT_ROBOT=roomba PRIORITY=3`.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <spdlog/sinks/sink.h>

namespace wheelwright::daemon {

// Names (capitals, digits, underscores) and values, added to every entry.
using JournalFields = std::vector<std::pair<std::string, std::string>>;

// Nothing where the system has no journal, or where standard error does not go to it.
std::shared_ptr<spdlog::sinks::sink> make_journal_sink(const JournalFields& fields);

}  // namespace wheelwright::daemon
