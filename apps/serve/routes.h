// Routes of the server as a table, also the source of the description for programs, with JSON Schemas of the server's
// answers.
#pragma once

#include <httplib.h>

#include <functional>
#include <string>
#include <vector>

#include "serve/option_words.h"
#include "serve/settings.h"
#include "serve/works/work_list.h"

namespace clearcut::serve {

/// Schemas by name, referenced by routes: Route::schema.
Json schemas();

/// Data common to all routes.
struct Service {
  const Settings& settings;
  std::filesystem::path folder;  ///< folder of the session
  std::string options;           ///< options of plan and verify, as JSON
  std::vector<KnownOption> plan_options, check_options;
  WorkList works;
  std::atomic<std::size_t> followers = 0;  ///< connections with events
  std::atomic<std::size_t> questions = 0;  ///< questions with a waiting client

  Service(const Settings& given, std::filesystem::path place, std::string options_json);
};

struct Route {
  std::string method;                                ///< GET, POST, DELETE
  std::string path;                                  ///< in OpenAPI's form: /plan/{id}/events
  std::string summary;                               ///< one line
  std::vector<std::string> form;                     ///< accepted fields of the form
  std::vector<std::pair<int, std::string>> answers;  ///< status, and its meaning
  std::string type = "application/json";             ///< media type of the answer
  std::function<void(Service&, const httplib::Request&, httplib::Response&)> handler;
  /// For requests with a form, read in pieces.
  std::function<void(Service&, const httplib::Request&, httplib::Response&, const httplib::ContentReader&)>
      reader;
  std::string schema{};     ///< schema of a good answer, by its name in schemas(); "": any
  bool needs_first = true;  ///< the first field of the form cannot be left out
};

const std::vector<Route>& routes();

/// OpenAPI 3.1.
std::string openapi_json();

/// {"error": "..."}
void answer_refusal(httplib::Response& response, int status, const std::string& text);
void answer_json(httplib::Response& response, int status, const Json& json);

// The handlers, by route.
void post_plan(Service& service, const httplib::Request& request, httplib::Response& response,
               const httplib::ContentReader& content);
void post_elements(Service& service, const httplib::Request& request, httplib::Response& response,
                   const httplib::ContentReader& content);
void post_tour(Service& service, const httplib::Request& request, httplib::Response& response,
               const httplib::ContentReader& content);
void get_plan(Service& service, const httplib::Request& request, httplib::Response& response);
void drop_plan(Service& service, const httplib::Request& request, httplib::Response& response);
void get_events(Service& service, const httplib::Request& request, httplib::Response& response);
void get_result(Service& service, const httplib::Request& request, httplib::Response& response);
void post_check(Service& service, const httplib::Request& request, httplib::Response& response,
                const httplib::ContentReader& content);
void post_info(Service& service, const httplib::Request& request, httplib::Response& response,
               const httplib::ContentReader& content);
void post_compare(Service& service, const httplib::Request& request, httplib::Response& response,
                  const httplib::ContentReader& content);

}  // namespace clearcut::serve
