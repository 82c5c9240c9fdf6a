// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "tutavia/io/plan_json.hpp"
#include "tutavia/search/search_record.hpp"

/// \file
/// append_trace: the events of searches, as lines of JSON.

namespace tutavia {

/// Appends one search to a trace: a line with the query and the status (as in a result file), then
/// one line for each event, in order. Every line is an object with a member `event`:
///
///     {"event":"search","search":"rea_star","status":"success","start":[x,y],"goal":[x,y],
///      "safety_radius":r}
///     {"event":"expanded","at":[x,y]}
///     {"event":"generated","at":[x,y]}
///     {"event":"interval","from":[x,y],"to":[x,y],"side":"start"}
///     {"event":"rectangle","min":[x,y],"max":[x,y],"side":"start"}
///     {"event":"edge","from":[x,y],"to":[x,y]}
///
/// A `side` is "start" or "goal": the end of the query from which the rectangle was reached.
inline void append_trace(std::string& text, const ResultHeader& header, std::string_view status,
                         const SearchRecord& record) {
  using Kind = SearchRecord::Event::Kind;
  const auto add = [&](const detail::ResultJson& line) { text.append(line.dump()).append("\n"); };
  add({{"event", "search"},
       {"search", header.search},
       {"status", status},
       {"start", detail::to_json(header.start)},
       {"goal", detail::to_json(header.goal)},
       {"safety_radius", header.safety_radius}});
  for (const auto& [kind, from, to, side] : record.events) {
    const char* grown_from = side == SearchSide::start ? "start" : "goal";
    const auto a = detail::to_json(from), b = detail::to_json(to);
    switch (kind) {
      case Kind::expanded:
        add({{"event", "expanded"}, {"at", a}});
        break;
      case Kind::generated:
        add({{"event", "generated"}, {"at", a}});
        break;
      case Kind::interval:
        add({{"event", "interval"}, {"from", a}, {"to", b}, {"side", grown_from}});
        break;
      case Kind::rectangle:
        add({{"event", "rectangle"}, {"min", a}, {"max", b}, {"side", grown_from}});
        break;
      case Kind::edge:
        add({{"event", "edge"}, {"from", a}, {"to", b}});
        break;
    }
  }
}

}  // namespace tutavia
