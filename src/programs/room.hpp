#pragma once

#include <string>

namespace programs {

/// The memory that this process may use [bytes]: what the machine has, or less where a limit (ulimit -v) says so.
double room();

/// Refuses before it is begun what cannot be held.
/// \param what the subject of the message, such as "5000000 particles"
/// \param bytes that it takes at the least \param remedy what to take instead
/// \throws particles::InvalidInput if that is more than there is
void check_room(const std::string& what, double bytes, const std::string& remedy);

/// The same for sparse matrices, whose entries are numbered by an int.
/// \param entries of the largest of them \param bytes of all
void check_room_of_entries(const std::string& what, double entries, double bytes, const std::string& remedy);

}  // namespace programs
