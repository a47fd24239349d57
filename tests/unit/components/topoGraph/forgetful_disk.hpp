// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>

#include "components/topoGraph/storage/disk.hpp"

namespace enfilade::topo_graph::test {

struct PowerCut {};

/// A file system that keeps, when the power is cut, any part of what was not synced. `honest` = false: one
/// that says it has synced and has not.
class ForgetfulDisk final : public Disk {
 public:
  ForgetfulDisk(std::uint64_t seed, bool honest) : random_(seed), honest_(honest) {}

  int steps_to_live = 1 << 30;

  void create(const Path& path, std::string_view text) override {
    live();
    if (names_.count(path.string())) throw std::logic_error(path.string() + " exists");
    names_[path.string()] = std::make_shared<File>(File{std::string(text), {}});
  }
  void sync(const Path& path) override {
    live();
    sync_file(path);
  }
  void append(const Path& path, std::string_view text) override {
    live();
    names_.at(path.string())->text += text;
    live();
    sync_file(path);
  }
  void rename(const Path& from, const Path& to) override {
    live();
    names_[to.string()] = names_.at(from.string());
    names_.erase(from.string());
  }
  void sync_folder(const Path&) override {
    live();
    if (honest_) durable_ = names_;
  }
  bool exists(const Path& path) const noexcept override { return names_.count(path.string()) > 0; }
  bool link(const Path& file, const Path& name) noexcept override {
    if (steps_to_live < 0 || !names_.count(file.string())) return false;
    names_[name.string()] = names_.at(file.string());
    return true;
  }
  void remove(const Path& path) noexcept override {
    if (steps_to_live >= 0) names_.erase(path.string());
  }

  /// Each name that was not synced is as it was or as it is now; what was not synced of a text is cut off
  /// anywhere, or has a hole.
  void cut_power() {
    std::map<std::string, std::shared_ptr<File>> kept;
    for (const auto* names : {&durable_, &names_})
      for (const auto& [name, file] : *names) kept.emplace(name, nullptr);
    for (auto& [name, file] : kept) {
      const auto& from = random_() % 2 ? durable_ : names_;
      const auto found = from.find(name);
      if (found != from.end()) file = found->second;
    }
    std::erase_if(kept, [](const auto& entry) { return !entry.second; });
    names_ = durable_ = kept;
    for (auto& [name, file] : names_) forget_some(*file);
    steps_to_live = 1 << 30;
  }

  std::optional<std::string> read(const std::string& name) const {
    const auto found = names_.find(name);
    return found == names_.end() ? std::nullopt : std::optional(found->second->text);
  }

 private:
  struct File {
    std::string text;
    std::optional<std::string> durable;
  };

  void live() {
    if (--steps_to_live < 0) throw PowerCut{};
  }

  void sync_file(const Path& path) {
    const auto& file = names_.at(path.string());
    if (honest_) file->durable = file->text;
  }

  /// Texts only grow.
  void forget_some(File& file) {
    const std::size_t safe = file.durable ? file.durable->size() : 0;
    const std::size_t lost = file.text.size() - safe;
    if (lost > 0 && random_() % 2)
      file.text.resize(safe + random_() % (lost + 1));
    else if (lost > 0)
      file.text.replace(safe + random_() % lost, 1 + random_() % lost, 1 + random_() % lost, '\0');
    file.durable = file.text;
  }

  std::mt19937_64 random_;
  bool honest_;
  std::map<std::string, std::shared_ptr<File>> names_, durable_;
};

}  // namespace enfilade::topo_graph::test
