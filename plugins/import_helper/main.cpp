// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
// Reads one foreign file for the program that started it, so that a crash in a library stays here. The
// request and the answer are open files (plugins/host/helper_process.h); of all plugins only the one needed
// is loaded.
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QObject>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>

#include "plugins/host/helper_process.h"
#include "plugins/host/import_codec.h"
#include "plugins/host/plugin_catalogue.h"
#include "plugins/sdk/file_name.h"
#include "plugins/sdk/importer.h"

namespace spin {
namespace {

Error noReader(const std::string& path, const PluginCatalogue& catalogue, const char* interfaceId) {
  std::string known;
  for (const PluginEntry& entry : catalogue.entries)
    if (entry.interfaceId == interfaceId)
      for (const std::string& extension : entry.extensions) known += (known.empty() ? "" : ", ") + extension;
  return badInput("The file could not be read", path, "no plugin reads files with this ending",
                  known.empty() ? "Install the import plugins" : "Use one of: " + known);
}

template <class Interface>
Result<Interface*> importerFor(const std::string& path, const char* interfaceId) {
  const PluginCatalogue catalogue = readPluginCatalogue(pluginFolders());
  const PluginEntry* entry = findPlugin(catalogue, interfaceId, lowerCaseExtension(path));
  if (!entry) return noReader(path, catalogue, interfaceId);
  const Result<QObject*> object = loadPlugin(*entry);
  if (!object) return object.error();
  auto* importer = qobject_cast<Interface*>(*object);
  if (!importer)
    return Error{ErrorKind::Failed, "The plugin could not be used", entry->path,
                 "it lacks the interface it names", "Install the program again"};
  return importer;
}

template <class T>
Status answerWith(ByteWriter& out, const Result<T>& result) {
  if (!result) return result.error();
  out.put(std::uint8_t{1});
  encode(out, *result);
  return {};
}

Status perform(const HelperRequest& request, ByteWriter& out) {
  if (request.task == ImportTask::ReadModel) {
    const auto importer = importerFor<ModelImporter>(request.path, SPIN_MODEL_IMPORTER_IID);
    if (!importer) return importer.error();
    return answerWith(out, (*importer)->read(request.path, request.options));
  }
  const auto importer = importerFor<TerrainImporter>(request.path, SPIN_TERRAIN_IMPORTER_IID);
  if (!importer) return importer.error();
  if (request.task == ImportTask::ReadTerrain)
    return answerWith(out, (*importer)->read(request.path, request.options));
  if (request.task == ImportTask::ReadLayer) return answerWith(out, (*importer)->readLayer(request.path));
  if (request.task == ImportTask::ReadRaster) return answerWith(out, (*importer)->readRaster(request.path));
  out.put(std::uint8_t{1});
  return (*importer)->writeLayer(request.layer, request.format, request.terrain, request.path);
}

/// Exceptions of the libraries end here; the memory one has its own kind.
Status performGuarded(const HelperRequest& request, ByteWriter& out) {
  try {
    return perform(request, out);
  } catch (const std::bad_alloc&) {
    return Error{ErrorKind::OutOfResources, "The file could not be read", request.path,
                 "reading it takes more memory than is allowed for an import",
                 "Reduce the file, or cut out the part you need"};
  } catch (const std::exception& exception) {
    return badInput("The file could not be read", request.path, exception.what(),
                    "Open it in the program that made it and export it again");
  }
}

bool writeAll(const std::vector<char>& bytes) {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t n = write(kHelperAnswerFd, bytes.data() + done, bytes.size() - done);
    if (n <= 0) return false;
    done += static_cast<std::size_t>(n);
  }
  return true;
}

int run() {
  struct stat about {};
  void* data = MAP_FAILED;
  if (fstat(kHelperRequestFd, &about) == 0 && S_ISREG(about.st_mode) && about.st_size > 0)
    data =
        mmap(nullptr, static_cast<std::size_t>(about.st_size), PROT_READ, MAP_PRIVATE, kHelperRequestFd, 0);
  if (data == MAP_FAILED) {
    std::fputs("spindrift-import-helper is started by spindrift and spindrift-cli, not by hand\n", stderr);
    return 2;
  }
  const Result<HelperRequest> request =
      decodeRequest(static_cast<const char*>(data), static_cast<std::size_t>(about.st_size));
  ByteWriter out;
  const Status status = request ? performGuarded(*request, out) : Status(request.error());
  if (!status) {
    out = ByteWriter();
    out.put(std::uint8_t{0});
    encode(out, status.error());
  }
  const std::vector<char> payload = out.take();
  return writeAll(sealAnswer(payload)) && writeAll(payload) ? 0 : 1;
}

}  // namespace
}  // namespace spin

int main() {
  // OpenCV reads these when it is loaded. Larger pictures are refused before memory is taken for them.
  setenv("OPENCV_IO_MAX_IMAGE_WIDTH", "32768", 1);
  setenv("OPENCV_IO_MAX_IMAGE_HEIGHT", "32768", 1);
  setenv("OPENCV_IO_MAX_IMAGE_PIXELS", "268435456", 1);
  const int code = spin::run();
  std::fflush(nullptr);
  // The answer is out: what the libraries do while they are torn down can no longer spoil it.
  _exit(code);
}
