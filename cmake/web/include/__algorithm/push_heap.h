// std::push_heap as g++'s standard library has it; see clearcut_order.h. The library's own takes another name.
#pragma once

#include <__algorithm/comp.h>
#include <__algorithm/comp_ref_type.h>
#include <__algorithm/unwrap_iter.h>
#include <__iterator/iterator_traits.h>
#include <clearcut_order.h>

#include <type_traits>

#define push_heap clearcut_other_push_heap
#include_next <__algorithm/push_heap.h>
#undef push_heap

_LIBCPP_BEGIN_NAMESPACE_STD

template <class It, class Less>
inline _LIBCPP_CONSTEXPR_AFTER_CXX17 void push_heap(It first, It last, Less less) {
  clearcut_order::push_heap(first, last, less);
}
template <class It>
inline _LIBCPP_CONSTEXPR_AFTER_CXX17 void push_heap(It first, It last) {
  _VSTD::push_heap(first, last, __less<typename iterator_traits<It>::value_type>());
}

_LIBCPP_END_NAMESPACE_STD
