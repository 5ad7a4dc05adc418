#include "daemon/telemetry/http_answer.hpp"

#include <string>

namespace wheelwright::daemon::telemetry {
namespace {

namespace http = boost::beast::http;

// The page needs nothing from elsewhere, shows up in no frame of another page, and tells nobody the token in
// its address.
constexpr const char* content_policy =
    "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data:; "
    "connect-src 'self' ws: wss:; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

HttpResponse answer(const HttpRequest& request, http::status status, const char* type,
                    std::string_view body) {
  HttpResponse response(status, request.version());
  response.keep_alive(request.keep_alive());
  response.set(http::field::content_type, type);
  response.set(http::field::cache_control, "no-store");
  response.set("X-Content-Type-Options", "nosniff");
  response.set("Referrer-Policy", "no-referrer");
  response.set("Content-Security-Policy", content_policy);
  response.body() = std::string(body);
  response.prepare_payload();
  if (request.method() == http::verb::head) response.body().clear();  // Content-Length stays
  return response;
}

HttpResponse line(const HttpRequest& request, http::status status, const std::string& text) {
  return answer(request, status, "text/plain; charset=utf-8", text + "\n");
}

// Who is refused does not keep the connection.
HttpResponse closing(HttpResponse response) {
  response.keep_alive(false);
  return response;
}

}  // namespace

HttpResponse http_answer(const HttpRequest& request, Access access, std::string_view page) {
  if (access == Access::no_token) {
    return closing(
        line(request, http::status::unauthorized,
             "This robot wants its token: add ?token=TOKEN, which is live_view.token of its configuration."));
  }
  if (access == Access::foreign) {
    return closing(line(
        request, http::status::forbidden,
        "Only this machine's own addresses are answered here (http://127.0.0.1, http://localhost), and no "
        "page from elsewhere; live_view.token lets others in."));
  }
  if (request.method() != http::verb::get && request.method() != http::verb::head) {
    HttpResponse response = line(request, http::status::method_not_allowed, "There is only GET here.");
    response.set(http::field::allow, "GET, HEAD");
    return response;
  }
  const auto target = request.target();
  const auto path = target.substr(0, target.find('?'));
  if (path != "/") return line(request, http::status::not_found, "There is only one page here: /");
  return answer(request, http::status::ok, "text/html; charset=utf-8", page);
}

HttpResponse no_subprotocol(const HttpRequest& request) {
  return line(request, http::status::bad_request,
              "Ask for the WebSocket subprotocol foxglove.sdk.v1 or foxglove.websocket.v1.");
}

HttpResponse no_room(const HttpRequest& request) {
  return closing(line(request, http::status::service_unavailable,
                      "As many are connected to this robot as there is room for; close another page of it."));
}

}  // namespace wheelwright::daemon::telemetry
