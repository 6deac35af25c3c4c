// Handlers of the routes.
#include <clearcut/error.h>
#include <clearcut/file.h>

#include <fstream>
#include <regex>

#include "serve/routes.h"
#include "serve/upload.h"
#include "serve/works/result_files.h"

namespace clearcut::serve {
namespace {

using httplib::ContentReader;
using httplib::Request;
using httplib::Response;
namespace fs = std::filesystem;

/// Counts a client with a long connection.
class Place {
 public:
  explicit Place(std::atomic<std::size_t>& count) : count_(count), number_(++count) {}
  ~Place() { --count_; }
  Place(const Place&) = delete;
  Place& operator=(const Place&) = delete;
  std::size_t number() const { return number_; }

 private:
  std::atomic<std::size_t>& count_;
  std::size_t number_;
};

constexpr double kHeartbeat = 10;  // s between signs of life of events
constexpr double kLongestUpload = 60;

/// Reads the form into `upload`. Throws Refusal. `response` is set if the request is too large to be read.
void read_form(const Request& request, const Response& response, const ContentReader& content,
               Upload& upload) {
  if (!request.is_multipart_form_data()) throw Refusal{400, "send a form with files: multipart/form-data"};
  std::optional<Refusal> refusal;
  const auto began = Clock::now();
  const auto guarded = [&](const auto& action) {
    try {
      if (std::chrono::duration<double>(Clock::now() - began).count() > kLongestUpload)
        throw Refusal{408, "the files came too slowly"};
      action();
      return true;
    } catch (const Refusal& found) {
      refusal = found;
      return false;
    }
  };
  const bool whole = content(
      [&](const httplib::MultipartFormData& field) {
        return guarded([&] { upload.begin(field.name, field.filename); });
      },
      [&](const char* data, std::size_t size) { return guarded([&] { upload.add(data, size); }); });
  if (refusal) throw *refusal;
  if (!whole && response.status == 413) throw Refusal{413, kTooLarge};
  if (!whole) throw Refusal{400, "the request ended early, or is no form"};
  upload.finish();
}

bool is_job(const std::string& name) {
  return fs::path(name).extension() == ".toml";
}

/// Words of the request's options, checked, and its job. Throws Refusal.
std::vector<std::string> option_words(const Upload& upload, const std::vector<KnownOption>& options) {
  try {
    const std::string part = upload.file_of("part"), elements = upload.file_of("job");
    for (const std::string& job : {is_job(part) ? part : "", elements}) {
      if (!job.empty()) check_job(read_file((upload.folder() / job).string()), job);
    }
    return checked_words(words_of(upload.text_of("options")), options, upload.files());
  } catch (const InputError& error) {
    throw Refusal{400, error.what()};
  }
}

WorkPtr new_work(Service& service, Upload& upload, const std::string& id) {
  if (!service.works.has_room()) throw Refusal{503, "too many plans wait; try again later"};
  return std::make_shared<Work>(id, upload.take());
}

/// Runs `action` and answers with its refusal, if any.
template <typename Action>
void refusing(Response& response, const Action& action) {
  try {
    action();
  } catch (const Refusal& refusal) {
    if (refusal.status == 503) response.set_header("Retry-After", "5");
    if (refusal.status != 503)
      response.set_header("Connection", "close");  // the rest of the request is not read
    answer_refusal(response, refusal.status, refusal.text);
  }
}

std::vector<std::string> joined(std::vector<std::string> command, const std::vector<std::string>& options,
                                const std::vector<std::string>& results) {
  command.insert(command.end(), options.begin(), options.end());
  command.insert(command.end(), results.begin(), results.end());
  return command;
}

std::string part_of(const Upload& upload) {
  const std::string part = upload.file_of("part");
  if (part.empty()) throw Refusal{400, "the part is missing; send its file as the field 'part'"};
  return part;
}

/// The uploaded file of points, or the lattice in words; no other text, since the command might read it as a file's
/// name.
std::string tour_input(const Upload& upload) {
  static const std::regex lattice_words("[1-9][0-9]{0,3}x[1-9][0-9]{0,3}");
  const std::string points = upload.file_of("points"), lattice = upload.text_of("lattice");
  if (points.empty() == lattice.empty())
    throw Refusal{400, "send points as the file of the field 'points', or a lattice as the field 'lattice'"};
  if (points.empty() && !std::regex_match(lattice, lattice_words))
    throw Refusal{400, "a lattice is COLUMNSxROWS such as 30x20, each at most 9999"};
  return points.empty() ? lattice : points;
}

struct Task {
  std::vector<std::string> words;
  bool has_verdict = true;
};

/// Queues the work made by `task_of` from a request's form; answers with the addresses of its state and its results.
template <typename TaskOf>
void answer_queued(Service& service, const Request& request, Response& response, const ContentReader& content,
                   const TaskOf& task_of) {
  refusing(response, [&] {
    const std::string id = new_id();
    Upload upload(service.folder / id / "work", service.settings.upload);
    read_form(request, response, content, upload);
    const Task task = task_of(upload);
    const WorkPtr work = new_work(service, upload, id);
    work->words = task.words;
    work->has_verdict = task.has_verdict;
    service.works.add(work, true);
    answer_json(response, 202,
                {{"id", id},
                 {"status", "/plan/" + id},
                 {"events", "/plan/" + id + "/events"},
                 {"command", work->words}});
  });
}

WorkPtr work_of(Service& service, const Request& request, Response& response) {
  WorkPtr work = service.works.find(request.matches[1]);
  if (!work) answer_refusal(response, 404, "there is no plan of that name, or no more");
  return work;
}

/// Sends a file in pieces; the work keeps the file alive.
void stream_file(const WorkPtr& work, const std::string& file, const std::string& type, Response& response) {
  const fs::path path = work->folder / "results" / file;
  std::error_code absent;
  const auto size = fs::file_size(path, absent);
  const auto stream = std::make_shared<std::ifstream>(path, std::ios::binary);
  if (absent || !*stream) return answer_refusal(response, 404, "there is no such result");
  if (size == 0) return response.set_content("", type);
  response.set_content_provider(
      size, type, [work, stream](std::size_t at, std::size_t length, httplib::DataSink& sink) {
        constexpr std::size_t kPiece = 1U << 16;
        std::string piece(std::min(kPiece, length), '\0');
        stream->seekg(static_cast<std::streamoff>(at));
        stream->read(piece.data(), static_cast<std::streamsize>(piece.size()));
        return stream->gcount() > 0 && sink.write(piece.data(), static_cast<std::size_t>(stream->gcount()));
      });
}

}  // namespace

void post_plan(Service& service, const Request& request, Response& response, const ContentReader& content) {
  answer_queued(service, request, response, content, [&](const Upload& upload) {
    return Task{joined({"plan", part_of(upload)}, option_words(upload, service.plan_options),
                       {"--output=results/program.ngc", "--certificate=results/certificate.json",
                        "--svg=results/picture.svg", "--report=results/report.html",
                        "--setup-sheet=results/setup-sheet.html"})};
  });
}

void post_elements(Service& service, const Request& request, Response& response,
                   const ContentReader& content) {
  answer_queued(service, request, response, content, [&](const Upload& upload) {
    std::vector<std::string> command{"elements"};
    const std::string job = upload.file_of("job");
    if (!job.empty()) command.push_back(job);
    return Task{
        joined(command, option_words(upload, known_options(service.options, "elements")),
               {"--output=results/program.ngc", "--certificate=results/certificate.json",
                "--svg=results/picture.svg", "--html=results/report.html", "--points=results/points.csv"})};
  });
}

void post_tour(Service& service, const Request& request, Response& response, const ContentReader& content) {
  answer_queued(service, request, response, content, [&](const Upload& upload) {
    return Task{
        joined({"tour", tour_input(upload)}, option_words(upload, known_options(service.options, "tour")),
               {"--json=results/tour.json", "--svg=results/picture.svg"}),
        false};
  });
}

void get_plan(Service& service, const Request& request, Response& response) {
  if (const WorkPtr work = work_of(service, request, response))
    answer_json(response, 200, service.works.status(work));
}

void drop_plan(Service& service, const Request& request, Response& response) {
  if (!service.works.drop(request.matches[1]))
    return answer_refusal(response, 404, "there is no plan of that name, or no more");
  answer_json(response, 200, {{"state", "cancelled"}});
}

void get_events(Service& service, const Request& request, Response& response) {
  const WorkPtr work = work_of(service, request, response);
  if (!work) return;
  const auto place = std::make_shared<Place>(service.followers);
  if (place->number() > service.settings.most_followers) {
    response.set_header("Retry-After", "5");
    return answer_refusal(response, 503, "too many connections follow plans; ask for the state instead");
  }
  const auto seen = std::make_shared<unsigned>(~0U);
  response.set_chunked_content_provider(
      "text/event-stream", [&service, work, place, seen](std::size_t, httplib::DataSink& sink) {
        const auto status = service.works.next_status(work, *seen, kHeartbeat);
        const std::string text =
            status ? "data: " + status->dump(-1, ' ', false, Json::error_handler_t::replace) + "\n\n"
                   : ": still here\n\n";
        const bool arrived = sink.write(text.data(), text.size());
        const bool is_last = status && (*status)["state"] != "waiting" && (*status)["state"] != "running";
        if (is_last) sink.done();
        return arrived && (is_last || !service.works.is_stopped());
      });
}

void get_result(Service& service, const Request& request, Response& response) {
  const WorkPtr work = work_of(service, request, response);
  if (!work) return;
  const std::string name = request.path.substr(request.path.rfind('/') + 1);
  const ResultKind* const kind = kind_of_result(name);
  if (kind == nullptr) return answer_refusal(response, 404, "there is no such result");
  // A page with its own origin, permitted to run its scripts but not to fetch.
  const std::string_view type = kind->type;
  if (type.starts_with("text/html") || type.starts_with("image/svg"))
    response.set_header(
        "Content-Security-Policy",
        "sandbox allow-scripts allow-downloads; default-src 'none'; script-src 'unsafe-inline'; "
        "style-src 'unsafe-inline'; img-src data: blob:; frame-ancestors 'self'");
  stream_file(work, file_of_result(*kind, name), kind->type, response);
}

void post_check(Service& service, const Request& request, Response& response, const ContentReader& content) {
  answer_queued(service, request, response, content, [&](const Upload& upload) {
    const std::string program = upload.file_of("program"), part = upload.file_of("part");
    if (program.empty()) throw Refusal{400, "the program is missing; send its file as the field 'program'"};
    std::vector<std::string> command{"verify", program};
    if (!part.empty()) command.push_back("--part=" + part);
    return Task{joined(
        command, option_words(upload, service.check_options),
        {"--json=results/certificate.json", "--svg=results/picture.svg", "--report=results/report.html"})};
  });
}

void post_compare(Service& service, const Request& request, Response& response,
                  const ContentReader& content) {
  answer_queued(service, request, response, content, [&](const Upload& upload) {
    return Task{joined({"compare", part_of(upload)},
                       option_words(upload, known_options(service.options, "compare")), {"--json"}),
                false};
  });
}

/// Waits for the command, and answers with its state and its printed JSON.
void post_info(Service& service, const Request& request, Response& response, const ContentReader& content) {
  refusing(response, [&] {
    const Place place(service.questions);
    if (place.number() > service.settings.most_waiting / 2)
      throw Refusal{503, "too many questions are asked; try again later"};
    const std::string id = new_id();
    Upload upload(service.folder / id / "work", service.settings.upload);
    read_form(request, response, content, upload);
    const std::string part = part_of(upload);
    const auto options = option_words(upload, known_options(service.options, "info"));
    const WorkPtr work = new_work(service, upload, id);
    work->words = joined({"info", part}, options, {"--json"});
    service.works.add(work, false);
    service.works.wait(work);
    Json json = service.works.status(work);
    for (const char* own : {"id", "results", "verdict"}) json.erase(own);
    const fs::path text = work->folder / "results/text.txt";
    Json said = fs::exists(text) ? Json::parse(read_file(text.string()), nullptr, false) : Json();
    json["info"] = said.is_object() ? said : Json();
    if (said.is_object()) {  // the command gives no verdict, by which finished plans and checks are recognised
      json["state"] = name_of(WorkState::kDone);
      json.erase("message");
    }
    answer_json(response, 200, json);
  });
}

Service::Service(const Settings& given, fs::path place, std::string options_json)
    : settings(given),
      folder(std::move(place)),
      options(std::move(options_json)),
      plan_options(known_options(options, "plan")),
      check_options(known_options(options, "verify")),
      works(settings) {}

}  // namespace clearcut::serve
