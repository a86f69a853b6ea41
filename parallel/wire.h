// Bytes of messages and of the spool: fixed little-endian order, no padding, every read checked
// against the end. One field list per type serves writing, reading and describing: a type has
//
//   template <class Archive> void Fields(Archive& a) { a("name", member); … }
//
// or a free function Fields(a, value) beside the codec. Grammar of values: numbers as they are;
// bool as one byte; enumerations as their underlying number; std::vector, std::string: count (32
// bits), then the elements; std::optional: one byte, then the value.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace rayshade::parallel {

static_assert(std::endian::native == std::endian::little, "numbers travel in little-endian order");

// Bytes that are not what the reader expected: they came from outside, so this is an error and no
// CHECK.
class WireError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

template <class T>
concept WireNumber = std::is_arithmetic_v<T> || std::is_enum_v<T>;

// A struct that lies in memory as it does on the wire (its Fields in order, no padding) says so by
// kPacked: vectors of it are copied as a whole.
template <class T>
concept WirePacked = WireNumber<T> || requires {
  requires T::kPacked;
};

class ByteWriter {
 public:
  static constexpr bool kReading = false;

  template <class T>
  void operator()(const char*, T& value) {
    Put(value);
  }

  template <WireNumber T>
  void Put(const T& value) {
    Append(&value, sizeof(T));
  }
  template <class T, size_t n>
  void Put(const T (&values)[n]) {
    for (const T& v : values) Put(v);
  }
  void Put(const std::string& s) {
    Put(static_cast<uint32_t>(s.size()));
    Append(s.data(), s.size());
  }
  template <class T>
  void Put(const std::vector<T>& values) {
    Put(static_cast<uint32_t>(values.size()));
    if constexpr (WirePacked<T>) {
      static_assert(std::is_trivially_copyable_v<T>);
      Append(values.data(), values.size() * sizeof(T));
    } else {
      for (const T& v : values) Put(v);
    }
  }
  template <class T>
  void Put(const std::optional<T>& value) {
    Put(static_cast<uint8_t>(value.has_value()));
    if (value) Put(*value);
  }
  template <class... T>
  void Put(const std::variant<T...>& value) {
    Put(static_cast<uint8_t>(value.index()));
    std::visit([this](const auto& v) { Put(v); }, value);
  }
  // Shared constant data travels by value.
  template <class T>
  void Put(const std::shared_ptr<const T>& shared) {
    Put(static_cast<uint8_t>(shared != nullptr));
    if (shared) Put(*shared);
  }
  template <class T>
  requires std::is_class_v<T>
  void Put(const T& value) {
    T& mutable_value = const_cast<T&>(value);  // field lists are written once, for both directions
    if constexpr (requires { mutable_value.Fields(*this); }) {
      mutable_value.Fields(*this);
    } else {
      Fields(*this, mutable_value);
    }
  }

  // Bytes that are encoded already.
  void PutRaw(const std::vector<uint8_t>& encoded) { Append(encoded.data(), encoded.size()); }

  size_t size() const { return size_; }
  // What has been put, until the next call.
  std::span<const uint8_t> bytes() const { return {bytes_.data(), size_}; }
  void clear() { size_ = 0; }
  // The same, given away; the writer is empty then.
  std::vector<uint8_t> Take() {
    bytes_.resize(std::exchange(size_, 0));
    return std::exchange(bytes_, {});
  }

 private:
  void Append(const void* from, size_t count) {
    if (count > bytes_.size() - size_)
      bytes_.resize(std::max(2 * bytes_.size(), size_ + count + 64));
    if (count > 0) std::memcpy(bytes_.data() + size_, from, count);
    size_ += count;
  }

  std::vector<uint8_t> bytes_;  // the first size_ of them count
  size_t size_ = 0;
};

class ByteReader {
 public:
  static constexpr bool kReading = true;

  explicit ByteReader(std::span<const uint8_t> bytes) : bytes_(bytes) {}

  template <class T>
  void operator()(const char*, T& value) {
    Get(value);
  }

  template <WireNumber T>
  void Get(T& value) {
    if constexpr (std::is_same_v<T, bool>) {
      uint8_t byte;
      Get(byte);
      if (byte > 1) throw WireError("a truth value that is neither 0 nor 1");
      value = byte != 0;
    } else {
      Need(sizeof(T));
      std::memcpy(&value, bytes_.data() + at_, sizeof(T));
      at_ += sizeof(T);
    }
  }
  template <class T, size_t n>
  void Get(T (&values)[n]) {
    for (T& v : values) Get(v);
  }
  void Get(std::string& s) {
    const uint32_t n = Count(1);
    s.assign(reinterpret_cast<const char*>(bytes_.data() + at_), n);
    at_ += n;
  }
  template <class T>
  void Get(std::vector<T>& values) {
    if constexpr (WirePacked<T>) {
      values.resize(Count(sizeof(T)));
      if (values.empty()) return;
      std::memcpy(values.data(), bytes_.data() + at_, values.size() * sizeof(T));
      at_ += values.size() * sizeof(T);
    } else {
      values.clear();
      const uint32_t n = Count(1);
      for (uint32_t i = 0; i < n; ++i) Get(values.emplace_back());
    }
  }
  template <class T>
  void Get(std::optional<T>& value) {
    value.reset();
    if (Flag()) Get(value.emplace());
  }
  template <class... T>
  void Get(std::variant<T...>& value) {
    uint8_t index;
    Get(index);
    if (index >= sizeof...(T)) throw WireError("an unknown alternative");
    uint8_t i = 0;
    ((i++ == index ? Get(value.template emplace<T>()) : void()), ...);
  }
  template <class T>
  void Get(std::shared_ptr<const T>& shared) {
    shared = nullptr;
    if (!Flag()) return;
    if (++nesting_ > 64) throw WireError("objects nested too deeply");
    auto value = std::make_shared<T>();
    Get(*value);
    shared = std::move(value);
    --nesting_;
  }
  template <class T>
  requires std::is_class_v<T>
  void Get(T& value) {
    if constexpr (requires { value.Fields(*this); }) {
      value.Fields(*this);
    } else {
      Fields(*this, value);
    }
  }

  // How far reading has come, and whether that is the end.
  size_t at() const { return at_; }
  bool end() const { return at_ == bytes_.size(); }
  void ExpectEnd() const {
    if (!end()) throw WireError("more bytes than expected");
  }

 private:
  void Need(size_t n) const {
    if (bytes_.size() - at_ < n) throw WireError("fewer bytes than expected");
  }
  bool Flag() {
    bool flag;
    Get(flag);
    return flag;
  }
  // A count of elements of at least `least` bytes each: refused where they cannot be there.
  uint32_t Count(size_t least) {
    uint32_t n;
    Get(n);
    if (n > (bytes_.size() - at_) / least)
      throw WireError("a count larger than the bytes that are left");
    return n;
  }

  std::span<const uint8_t> bytes_;
  size_t at_ = 0;
  int nesting_ = 0;
};

}  // namespace rayshade::parallel
