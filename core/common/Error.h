// SPDX-License-Identifier: MIT
#pragma once

#include <exception>
#include <stdexcept>
#include <string>

namespace fodscope {

/// Something the user can mend: the input, the data or the environment is at fault.
/// what() is one sentence, "SUBJECT: what is wrong; what to do", fit for a status line and for standard error.
class Error : public std::runtime_error {
  public:
    /// @param subject the file, topic or setting at fault, e.g. "map.pcd"
    /// @param problem what is wrong with it, without a full stop
    /// @param remedy what the user can do, without a full stop
    Error(const std::string& subject, const std::string& problem, const std::string& remedy)
        : std::runtime_error(subject + ": " + problem + "; " + remedy),
          subject_(subject),
          problem_(problem),
          remedy_(remedy) {}

    const std::string& subject() const { return subject_; }
    const std::string& problem() const { return problem_; }
    const std::string& remedy() const { return remedy_; }

  private:
    std::string subject_;
    std::string problem_;
    std::string remedy_;
};

/// Thrown by a stage that was asked to stop. No partial result exists.
class Cancelled : public std::exception {
  public:
    const char* what() const noexcept override { return "cancelled"; }
};

}  // namespace fodscope
