// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/base/exceptions.h>
#include <setae/base/shared_exit.h>
#include <setae/output/files.h>

#include <cerrno>
#include <exception>
#include <fstream>
#include <system_error>

namespace Setae::Files
{
  namespace
  {
    /** The reason for which the system has refused the last call, if any. */
    std::string
    reason()
    {
      return errno == 0 ? std::string("the system gives no reason") :
                          std::generic_category().message(errno);
    }

    /** Whether all of @p text has reached the file. */
    bool
    write(const std::filesystem::path &name,
          const std::string           &text,
          const std::ios::openmode     mode)
    {
      errno = 0;
      std::ofstream stream(name, mode | std::ios::binary);
      stream << text;
      stream.close();
      return stream.good();
    }

    [[noreturn]] void
    fail(const std::filesystem::path &name, const std::string &why)
    {
      throw ExcRun("The file '" + name.string() +
                   "' cannot be written: " + why + ".");
    }
  } // namespace



  void
  replace(const std::filesystem::path &name, const std::string &text)
  {
    std::filesystem::path unfinished = name;
    unfinished += ".tmp";
    std::error_code error;
    if (!write(unfinished, text, std::ios::trunc))
      {
        const std::string why = reason();
        std::filesystem::remove(unfinished, error);
        fail(name, why);
      }
    std::filesystem::rename(unfinished, name, error);
    if (error)
      fail(name, error.message());
  }



  void
  append(const std::filesystem::path &name, const std::string &text)
  {
    std::error_code error;
    const auto      size = std::filesystem::file_size(name, error);
    if (write(name, text, std::ios::app))
      return;
    const std::string why = reason();
    if (!error)
      std::filesystem::resize_file(name, size, error);
    fail(name, why);
  }



  void
  on_first_rank(const MPI_Comm communicator, const std::function<void()> &write)
  {
    std::exception_ptr problem;
    if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
      try
        {
          write();
        }
      catch (...)
        {
          problem = std::current_exception();
        }
    const bool failed =
      dealii::Utilities::MPI::max(problem ? 1 : 0, communicator) == 1;
    if (problem)
      std::rethrow_exception(problem);
    AssertThrow(!failed, ExcOtherRank());
  }
} // namespace Setae::Files
