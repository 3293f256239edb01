#pragma once

#include <variant>

namespace scene {

/// A std::variant whose copying, moving and destroying are compiled once instead of in every source that holds one:
/// each of them is a table of functions, one per type, and these tables were a sixth of what parser and plan cost the
/// compiler. `Kinds::variant` is the std::variant. The header says `extern template struct Sealed<Kinds>;`, one source
/// `template struct Sealed<Kinds>;`.
template <class Kinds>
struct Sealed : Kinds::variant {
    using Base = typename Kinds::variant;
    using Base::Base;
    using Base::operator=;

    Sealed();
    Sealed(const Sealed& other);
    Sealed(Sealed&& other) noexcept;
    Sealed& operator=(const Sealed& other);
    Sealed& operator=(Sealed&& other) noexcept;
    ~Sealed();
};

template <class Kinds>
Sealed<Kinds>::Sealed() = default;
template <class Kinds>
Sealed<Kinds>::Sealed(const Sealed& other) = default;
template <class Kinds>
Sealed<Kinds>::Sealed(Sealed&& other) noexcept = default;
template <class Kinds>
Sealed<Kinds>& Sealed<Kinds>::operator=(const Sealed& other) = default;
template <class Kinds>
Sealed<Kinds>& Sealed<Kinds>::operator=(Sealed&& other) noexcept = default;
template <class Kinds>
Sealed<Kinds>::~Sealed() = default;

}  // namespace scene
