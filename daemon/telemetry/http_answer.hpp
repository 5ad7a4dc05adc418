// What is answered to a request over plain HTTP.
#pragma once

#include <utility>  // Boost.Asio 1.74 needs it and does not say so

#include <boost/beast/http.hpp>

#include <string_view>

#include "daemon/telemetry/access.hpp"

namespace wheelwright::daemon::telemetry {

using HttpRequest = boost::beast::http::request<boost::beast::http::string_body>;
using HttpResponse = boost::beast::http::response<boost::beast::http::string_body>;

// GET / gives the page, to those who may see it; anything else one line that says what would be right.
HttpResponse http_answer(const HttpRequest& request, Access access, std::string_view page);

// To a WebSocket client that speaks another protocol.
HttpResponse no_subprotocol(const HttpRequest& request);

// To a WebSocket client for whom there is no room.
HttpResponse no_room(const HttpRequest& request);

}  // namespace wheelwright::daemon::telemetry
