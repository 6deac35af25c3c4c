// std::nth_element as g++'s standard library has it; see clearcut_order.h. The library's own takes another name.
#pragma once

#include <__algorithm/comp.h>
#include <__algorithm/comp_ref_type.h>
#include <__algorithm/sort.h>
#include <__algorithm/unwrap_iter.h>
#include <__iterator/iterator_traits.h>
#include <clearcut_order.h>

#include <type_traits>

#define nth_element clearcut_other_nth_element
#include_next <__algorithm/nth_element.h>
#undef nth_element

_LIBCPP_BEGIN_NAMESPACE_STD

template <class It, class Less>
inline _LIBCPP_CONSTEXPR_AFTER_CXX17 void nth_element(It first, It nth, It last, Less less) {
  clearcut_order::nth_element(first, nth, last, less);
}
template <class It>
inline _LIBCPP_CONSTEXPR_AFTER_CXX17 void nth_element(It first, It nth, It last) {
  _VSTD::nth_element(first, nth, last, __less<typename iterator_traits<It>::value_type>());
}

_LIBCPP_END_NAMESPACE_STD
