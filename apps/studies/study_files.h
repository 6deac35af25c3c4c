// What `clearcut study` was asked for, and its files.
#pragma once

#include <clearcut/studies.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "terminal/progress.h"

namespace clearcut::cli {

struct StudyCommand {
  std::string name;
  std::string csv;
  std::string svg;
  studies::GeneticStudyOptions options;
  std::optional<int> threads;
  bool is_mpi = false;
  bool as_markdown = false;
  bool quiet = false;
};

/// How far a study is, for who sees it.
class StudyProgress {
 public:
  /// `done` of `total` runs are from earlier.
  StudyProgress(const StudyCommand& command, int done, int total);
  void show(int done, int total);

 private:
  std::optional<ProgressLine> line_;
};

/// The file of the rows while the study runs: every finished run is appended at once, so that a study that was stopped goes on where
/// it was. At the end it is written anew, sorted.
class RowFile {
 public:
  RowFile(const StudyCommand& command, const studies::GeneticStudy& study);

  /// What was in it; now it holds the complete runs of that, or none.
  std::string begin() const;

  /// In one piece: a reader sees whole runs.
  void append(const std::string& lines) const;

 private:
  const StudyCommand& command_;
  const studies::GeneticStudy& study_;
  bool is_file_;
};

/// States of islands as files of a folder beside the rows, which is there while runs are not finished.
class StateFolder : public studies::StateStore {
 public:
  explicit StateFolder(const std::string& csv) : folder_(csv + ".islands") {}

  std::vector<std::string> names() const override;
  std::optional<std::string> read(const std::string& name) const override;
  void write(const std::string& name, const std::string& text) override;
  void erase(const std::string& name) override;

 private:
  std::filesystem::path folder_;
};

}  // namespace clearcut::cli
