// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>

namespace enfilade::room_detector {

/// A large array of numbers that begin as zero. What is never written takes no memory: the system hands out
/// its pages at first use.
template <class T>
class ZeroedArray {
 public:
  ZeroedArray() = default;
  explicit ZeroedArray(std::size_t size) : values_(static_cast<T*>(std::calloc(size, sizeof(T)))) {
    if (!values_ && size > 0) throw std::bad_alloc();
  }

  bool empty() const { return !values_; }
  T* data() const { return values_.get(); }
  T& operator[](std::size_t i) const { return values_.get()[i]; }

 private:
  struct Free {
    void operator()(T* values) const { std::free(values); }
  };
  std::unique_ptr<T, Free> values_;
};

}  // namespace enfilade::room_detector
