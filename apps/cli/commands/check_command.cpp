// clearcut check: whether a certificate, the program and the part are unchanged.
#include <clearcut/certificate.h>
#include <clearcut/error.h>
#include <clearcut/file.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>

#include "arguments/certificate_info.h"
#include "commands/commands.h"
#include "terminal/output.h"

namespace clearcut::cli {
namespace {

using Json = nlohmann::ordered_json;

struct CheckCommand {
  std::string certificate;
  std::string program;
  std::vector<std::string> parts;
  bool again = false;
};

Json certificate_of(const std::string& file, const std::string& text) {
  const Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded() || !json.is_object())
    throw InputError(file, "is no certificate; name the JSON that --certificate or --json has written");
  return json;
}

/// The file given for an input of this name, else the name itself.
std::string place_of(const std::string& name, const std::vector<std::string>& given) {
  const auto base = [](const std::string& path) { return std::filesystem::path(path).filename(); };
  for (const std::string& path : given) {
    if (base(path) == base(name)) return path;
  }
  return name;
}

void check_file(const std::string& what, const std::string& path, const std::string& wanted,
                std::vector<std::string>& faults) {
  std::string found;
  try {
    found = sha256_hex(read_file(path));
  } catch (const InputError& error) {
    faults.push_back(what + ": " + error.what());
    return;
  }
  if (found != wanted) faults.push_back(what + " " + path + " is not the one that was certified");
}

/// The hash of the motion follows from the text of the certified program.
void check_motion(const std::string& path, const Json& program, std::vector<std::string>& faults) {
  if (sha256_hex(motion_text(read_file(path))) != program.at("motion_sha256").get<std::string>())
    faults.push_back("contradicts itself: /program/motion_sha256: is not that of the program");
}

/// A given part whose name matches no input is the part itself under another name.
void check_inputs(const Json& certificate, const CheckCommand& command, std::vector<std::string>& faults) {
  const Json& inputs = certificate.at("inputs");
  for (const Json& one : inputs) {
    const std::string name = one.at("name").get<std::string>();
    std::string path = place_of(name, command.parts);
    if (path == name && inputs.size() == 1 && command.parts.size() == 1) path = command.parts.front();
    check_file(one.at("role").get<std::string>(), path, one.at("sha256").get<std::string>(), faults);
  }
  const Json& program = certificate.at("program");
  const std::string path = command.program.empty() ? program.at("name").get<std::string>() : command.program;
  if (path.empty() || path == "-") return;
  const std::size_t before = faults.size();
  check_file("program", path, program.at("sha256").get<std::string>(), faults);
  if (faults.size() == before) check_motion(path, program, faults);
}

/// The recorded arguments, with the files given now.
std::vector<std::string> arguments_now(const Json& certificate, const CheckCommand& command) {
  auto arguments = certificate.at("question").at("arguments").get<std::vector<std::string>>();
  const std::string program = certificate.at("program").at("name").get<std::string>();
  for (std::string& one : arguments) {
    for (const Json& input : certificate.at("inputs")) {
      if (input.at("name").get<std::string>() == one) one = place_of(one, command.parts);
    }
    if (one == program && !command.program.empty()) one = command.program;
  }
  return arguments;
}

void check_again(const Json& certificate, const CheckCommand& command, std::vector<std::string>& faults) {
  const std::string kind = certificate.at("question").at("command").get<std::string>();
  if (kind != "plan" && kind != "verify") {
    faults.push_back("--again: certificates of '" + kind + "' cannot be computed again");
    return;
  }
  const auto arguments = arguments_now(certificate, command);
  const std::string program = certificate.at("program").at("name").get<std::string>();
  const std::string now =
      kind == "plan" ? plan_certificate(arguments, program) : verify_certificate(arguments);
  std::set<std::string> left_out = {"/seal", "/version"};
  // Names of files now in other places.
  if (!command.program.empty() || !command.parts.empty())
    left_out.merge(std::set<std::string>{"/source_file", "/question/arguments", "/question/noticed",
                                         "/program/name", "/inputs/*/name"});
  for (const std::string& one : certificate_differences(certificate.dump(), now, left_out))
    faults.push_back("again " + one);
}

int run(const CheckCommand& command) {
  const std::string text = read_file(command.certificate);
  const Json certificate = certificate_of(command.certificate, text);
  std::vector<std::string> faults = certificate_faults(text);
  for (std::string& fault : faults) fault = "schema " + fault;
  if (faults.empty()) {
    for (const std::string& one : certificate_contradictions(text))
      faults.push_back("contradicts itself: " + one);
    if (!seal_holds(text))
      faults.push_back("the certificate was altered after it was written" +
                       std::string(command.again ? "" : "; --again says where"));
    check_inputs(certificate, command, faults);
    if (command.again) check_again(certificate, command, faults);
  }
  for (const std::string& fault : faults) print_line(command.certificate + ": " + fault + "\n");
  if (faults.empty())
    print_line(command.certificate + ": holds; " + certificate.at("verdict").get<std::string>() + "\n");
  return faults.empty() ? kClean : kFault;
}

}  // namespace

void add_check_command(CLI::App& app, int& exit_code) {
  auto* command =
      app.add_subcommand("check", "Check a certificate: its form, its seal and the files named in it");
  command->group("Checking");
  auto state = std::make_shared<CheckCommand>();
  command->option_defaults()->group("Input");
  command->add_option("CERTIFICATE", state->certificate, "Certificate written by plan or verify")
      ->required()
      ->type_name("FILE");
  command->add_option("--program", state->program, "Path of the program, if it has moved")->type_name("FILE");
  command->add_option("--part", state->parts, "Path of an input file, if it has moved (repeatable)")
      ->type_name("FILE");
  command->add_flag("--again", state->again, "Compute the certificate again and compare every field");
  command->callback([state, &exit_code] { exit_code = run(*state); });
}

}  // namespace clearcut::cli
