// Debug pictures: any step may hand its state to a sink given as an argument, null by default.
//
//     Regions inset(..., DebugSink* debug = nullptr) {
//       if (debug) { debug->frame("raw offsets"); for (...) debug->line(a.x, a.y, b.x, b.y, "blue"); }
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace clearcut::inline base {

/// Takes primitives as plain numbers in mm, x right and y up, so that code of every folder can draw. Colours are
/// SVG's.
class DebugSink {
 public:
  virtual ~DebugSink() = default;
  /// Ends the picture before it, if any, and starts the next.
  virtual void frame(std::string_view title) = 0;
  virtual void line(double x0, double y0, double x1, double y1, std::string_view color) = 0;
  /// About (cx, cy); the ends need not be on the circle exactly. Equal ends: nothing is drawn.
  virtual void arc(double x0, double y0, double x1, double y1, double cx, double cy, bool counter_clockwise,
                   std::string_view color) = 0;
  virtual void polyline(const std::vector<std::pair<double, double>>& points, bool closed,
                        std::string_view color) = 0;
  virtual void dot(double x, double y, std::string_view label, std::string_view color) = 0;
};

/// Writes every frame that is not empty as FOLDER/PREFIX-001-title.svg, -002-..., scaled to its drawing. Numbers that
/// are not finite are left out, and counted in the title of the picture.
class SvgFrames : public DebugSink {
 public:
  /// The folder is made when the first frame is written.
  SvgFrames(std::filesystem::path folder, std::string prefix);
  /// Writes the last frame; a frame that cannot be written is dropped.
  ~SvgFrames() override;
  SvgFrames(const SvgFrames&) = delete;
  SvgFrames& operator=(const SvgFrames&) = delete;

  void frame(std::string_view title) override;
  void line(double x0, double y0, double x1, double y1, std::string_view color) override;
  void arc(double x0, double y0, double x1, double y1, double cx, double cy, bool counter_clockwise,
           std::string_view color) override;
  void polyline(const std::vector<std::pair<double, double>>& points, bool closed,
                std::string_view color) override;
  void dot(double x, double y, std::string_view label, std::string_view color) override;

  /// Writes the frame begun last. Throws std::runtime_error when the file cannot be written.
  void finish();
  const std::vector<std::filesystem::path>& written() const { return written_; }

 private:
  struct Dot {
    double x, y;
    std::string label, color;
  };
  bool take(double x, double y);
  void add_path(const std::string& data, std::string_view color);
  std::string picture() const;

  std::filesystem::path folder_;
  std::string prefix_;
  std::string title_;
  std::string paths_;
  std::vector<Dot> dots_;
  double min_x_ = 0, min_y_ = 0, max_x_ = 0, max_y_ = 0;
  bool empty_ = true;
  int skipped_ = 0;
  std::vector<std::filesystem::path> written_;
};

}  // namespace clearcut::inline base
