// Plans a pocket, cancels a plan, and plans on four threads at once.
#include <clearcut/clearcut.h>

#include <future>
#include <iostream>

// Corners x, y in mm; the third number bends the side that begins there (tangent of a quarter of its angle).
constexpr const char* kPocket = R"({
  "name": "pocket", "units": "mm", "top": 0, "depth": 4,
  "outer": [[0, 0, 0], [60, 0, 0], [60, 40, 0], [30, 40, 0], [30, 25, 0], [0, 25, 0]],
  "islands": [[[12, 12, 1], [20, 12, 1]]]
})";

clearcut::PlanResult plan(const clearcut::Part& part, const std::string& strategy) {
  clearcut::PlanOptions options;
  options.tools = {clearcut::parse_tool("endmill:6")};
  options.strategy = strategy;
  options.threads = 1;
  return clearcut::plan_part(part, options);
}

bool is_cancelled_when_asked(const clearcut::Part& part) {
  std::stop_source stop;
  clearcut::PlanOptions options;
  options.tools = {clearcut::parse_tool("endmill:6")};
  options.cancel = stop.get_token();
  options.progress = [&](const clearcut::Progress&) { stop.request_stop(); };
  try {
    clearcut::plan_part(part, options);
  } catch (const clearcut::Cancelled&) {
    return true;
  }
  return false;
}

int main() try {
  const clearcut::Part part = clearcut::read_part_text(kPocket, "pocket.json", {});
  const clearcut::PlanResult result = plan(part, "auto");
  std::cout << clearcut::write_table(result) << (result.findings.all.clean ? "clean" : "faults found")
            << '\n';

  const bool cancelled = is_cancelled_when_asked(part);
  std::cout << (cancelled ? "cancelled when asked" : "not cancelled") << '\n';

  std::vector<std::future<clearcut::PlanResult>> plans;
  for (const char* strategy : {"contour", "adaptive", "zigzag", "contour"})
    plans.push_back(std::async(std::launch::async, plan, part, strategy));
  bool all_clean = true;
  std::vector<std::string> programs;
  for (auto& one : plans) {
    const clearcut::PlanResult finished = one.get();
    all_clean = all_clean && finished.findings.all.clean;
    programs.push_back(finished.program);
  }
  const bool same = programs.front() == programs.back();
  std::cout << "four at once: " << (all_clean && same ? "clean, and the same again" : "not as they should be")
            << '\n';
  return result.findings.all.clean && cancelled && all_clean && same ? 0 : 1;
} catch (const clearcut::InputError& error) {
  std::cerr << error.what() << '\n';
  return 2;
}
