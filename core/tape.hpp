#pragma once
/// Values put one behind the other and taken off again in the same order: how a state is kept.
///
/// A type tells its members once, for both directions: a free function members(Tape&, T&) in
/// namespace shellback, or a member function of that name; small aggregates need not. Numbers are
/// kept with all their bits.
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "core/contract.hpp"

namespace shellback {

class Tape {
 public:
  /// What is on a tape.
  struct Content {
    std::vector<double> numbers;
    std::vector<std::int64_t> counts;  ///< whole numbers, and how long lists and texts are
    std::string text;
  };

  /// To be written.
  Tape() = default;
  /// To be read, from its beginning.
  explicit Tape(Content content) : content_(std::move(content)), reads_(true) {}

  /// Writes the values, or sets them to what comes next. Throws FileError where nothing comes.
  template <class... T>
  void operator()(T&... x) {
    (one(x), ...);
  }
  [[nodiscard]] bool reads() const { return reads_; }
  /// Read to the end.
  [[nodiscard]] bool ended() const;
  [[nodiscard]] const Content& content() const { return content_; }

 private:
  template <class T>
  struct IsVector : std::false_type {};
  template <class T>
  struct IsVector<std::vector<T>> : std::true_type {};
  template <class T>
  struct IsArray : std::false_type {};
  template <class T, std::size_t N>
  struct IsArray<std::array<T, N>> : std::true_type {};
  template <class T>
  struct IsOptional : std::false_type {};
  template <class T>
  struct IsOptional<std::optional<T>> : std::true_type {};
  template <class T>
  struct IsVariant : std::false_type {};
  template <class... T>
  struct IsVariant<std::variant<T...>> : std::true_type {};

  template <class T>
  void one(T& x) {
    if constexpr (std::is_same_v<T, double> || std::is_same_v<T, std::string> ||
                  std::is_same_v<T, std::vector<double>>) {
      value(x);
    } else if constexpr (std::is_integral_v<T> || std::is_enum_v<T>) {
      auto n = static_cast<std::int64_t>(x);
      count(n);
      x = static_cast<T>(n);
    } else if constexpr (IsVector<T>::value) {
      auto n = static_cast<std::int64_t>(x.size());
      length(n);
      x.resize(static_cast<std::size_t>(n));
      for (auto& each : x) one(each);
    } else if constexpr (IsArray<T>::value) {
      for (auto& each : x) one(each);
    } else if constexpr (IsOptional<T>::value) {
      bool there = x.has_value();
      one(there);
      if (reads_ && there) x.emplace();
      if (!there) x.reset();
      if (there) one(*x);
    } else if constexpr (IsVariant<T>::value) {
      auto which = static_cast<std::int64_t>(x.index());
      count(which);
      if (reads_) take_up(x, which, std::make_index_sequence<std::variant_size_v<T>>());
      std::visit([this](auto& held) { one(held); }, x);
    } else if constexpr (requires { x.members(*this); }) {
      x.members(*this);
    } else if constexpr (requires { members(*this, x); }) {
      members(*this, x);
    } else {
      few(x);
    }
  }

  /// Stands for a value of any type.
  struct Any {
    template <class T>
    operator T() const;
  };
  /// How many members an aggregate has.
  template <class T, class... Counted>
  static constexpr std::size_t count_members() {
    if constexpr (requires { T{Counted{}..., Any{}}; }) {
      return count_members<T, Counted..., Any>();
    } else {
      return sizeof...(Counted);
    }
  }

  /// All members of a struct that has no more than thirteen and does not tell them.
  template <class T>
  void few(T& x) {
    constexpr std::size_t count = count_members<T>();
    static_assert(count >= 1 && count <= 13, "tell its members");
    if constexpr (count == 1) {
      auto& [a] = x;
      (*this)(a);
    } else if constexpr (count == 2) {
      auto& [a, b] = x;
      (*this)(a, b);
    } else if constexpr (count == 3) {
      auto& [a, b, c] = x;
      (*this)(a, b, c);
    } else if constexpr (count == 4) {
      auto& [a, b, c, d] = x;
      (*this)(a, b, c, d);
    } else if constexpr (count == 5) {
      auto& [a, b, c, d, e] = x;
      (*this)(a, b, c, d, e);
    } else if constexpr (count == 6) {
      auto& [a, b, c, d, e, f] = x;
      (*this)(a, b, c, d, e, f);
    } else if constexpr (count == 7) {
      auto& [a, b, c, d, e, f, g] = x;
      (*this)(a, b, c, d, e, f, g);
    } else if constexpr (count == 8) {
      auto& [a, b, c, d, e, f, g, h] = x;
      (*this)(a, b, c, d, e, f, g, h);
    } else if constexpr (count == 9) {
      auto& [a, b, c, d, e, f, g, h, i] = x;
      (*this)(a, b, c, d, e, f, g, h, i);
    } else if constexpr (count == 10) {
      auto& [a, b, c, d, e, f, g, h, i, j] = x;
      (*this)(a, b, c, d, e, f, g, h, i, j);
    } else if constexpr (count == 11) {
      auto& [a, b, c, d, e, f, g, h, i, j, k] = x;
      (*this)(a, b, c, d, e, f, g, h, i, j, k);
    } else if constexpr (count == 12) {
      auto& [a, b, c, d, e, f, g, h, i, j, k, l] = x;
      (*this)(a, b, c, d, e, f, g, h, i, j, k, l);
    } else {
      auto& [a, b, c, d, e, f, g, h, i, j, k, l, m] = x;
      (*this)(a, b, c, d, e, f, g, h, i, j, k, l, m);
    }
  }

  /// The alternative of a variant with this number. Throws FileError where it has none.
  template <class T, std::size_t... k>
  void take_up(T& x, std::int64_t which, std::index_sequence<k...>) {
    const bool known = ((which == k && (x.template emplace<k>(), true)) || ...);
    if (!known) throw FileError("a kind of ending or note that is not known");
  }

  void value(double& x);
  void value(std::vector<double>& x);
  void value(std::string& x);
  void count(std::int64_t& n);
  /// A count of things that are each worth at least one entry of the tape.
  void length(std::int64_t& n);

  Content content_;
  bool reads_ = false;
  std::size_t number_ = 0;  ///< read so far
  std::size_t count_ = 0;
  std::size_t letter_ = 0;
};

}  // namespace shellback
