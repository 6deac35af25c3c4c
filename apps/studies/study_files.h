// Options of `clearcut study`, its files, and its run on the processes of an MPI job.
#pragma once

#include <clearcut/studies.h>

#include <filesystem>
#include <functional>
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

/// Appends to a file of finished work, at once. Throws InputError if it cannot be.
void append_to_file(const std::string& path, const std::string& lines);

/// Progress of a study, for terminals.
class StudyProgress {
 public:
  /// `done` of `total` runs are from earlier.
  StudyProgress(const StudyCommand& command, int done, int total);
  void show(int done, int total);

 private:
  std::optional<ProgressLine> line_;
};

/// The file of the rows while the study runs: every finished run is appended at once, so that a stopped study can
/// continue. At the end the file is written anew, sorted.
class RowFile {
 public:
  RowFile(const StudyCommand& command, const studies::GeneticStudy& study);

  /// The former content; afterwards the file contains only its complete runs, or none.
  std::string begin() const;

  /// In one piece: a reader sees whole runs.
  void append(const std::string& lines) const;

 private:
  const StudyCommand& command_;
  const studies::GeneticStudy& study_;
  bool is_file_;
};

/// States of islands as files of a folder beside the rows, which exists while runs are unfinished.
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

/// Runs all rows missing in the file, and calls `write`, which returns the exit code, with all rows on the process
/// with the file; returns the exit code of this process. Throws InputError if there is no file or no MPI.
int run_study_on_ranks(StudyCommand& command, const studies::GeneticStudy& study,
                       const std::function<int(const std::vector<studies::StudyRow>& rows)>& write);

}  // namespace clearcut::cli
