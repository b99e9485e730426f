#pragma once

/// The sanitizer that the tests are compiled with; a few tests cannot run under one.
namespace support {

#ifndef __has_feature
#define __has_feature(name) 0
#endif
#if defined(__SANITIZE_THREAD__) || __has_feature(thread_sanitizer)
inline constexpr bool threads_are_watched = true;
#else
inline constexpr bool threads_are_watched = false;
#endif
#if defined(__SANITIZE_ADDRESS__) || __has_feature(address_sanitizer)
inline constexpr bool addresses_are_watched = true;
#else
inline constexpr bool addresses_are_watched = false;
#endif

}  // namespace support
