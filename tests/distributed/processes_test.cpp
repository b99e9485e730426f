#include "distributed/processes.hpp"

#include <doctest/doctest.h>

#include <new>

#include "tests/distributed/world.hpp"
#include "tests/support/remedies.hpp"

using distributed::Processes;

TEST_CASE("processes: what fails on one fails on all, with the words of the first that failed") {
    const Processes all = support::world();
    const int last = all.count() - 1;
    CHECK(support::refusal([&] {
              all.together([&] {
                  if (all.rank() == last) throw base::FailedComputation("the particle at (1, 2)");
              });
          }) == "the particle at (1, 2)");
    const auto each_its_own = [&] {
        all.together([&] { throw base::InvalidInput("process " + std::to_string(all.rank())); });
    };
    CHECK_THROWS_WITH_AS(each_its_own(), "process 0", base::InvalidInput);
    CHECK(support::refusal([&] {
              all.together([] { throw std::bad_alloc(); });
          }).starts_with("there is not enough memory on process 0; "));
    CHECK_NOTHROW(all.together([] {}));
}

TEST_CASE("processes: numbers of all") {
    const Processes all = support::world();
    const int n = all.count();
    CHECK(all.sum(all.rank() + 1) == n * (n + 1) / 2);
    CHECK(all.largest(all.rank()) == n - 1);
    CHECK(all.where_largest(all.rank()) == n - 1);
    CHECK(all.where_least(1) == 0);
    CHECK(all.all(all.rank() < n));
    CHECK(all.all(all.rank() < n - 1) == false);
    CHECK(all.from(n - 1, all.rank()) == n - 1);
    CHECK(all.from(n - 1, std::string(static_cast<std::size_t>(all.rank()), 'x')).size() ==
          static_cast<std::size_t>(n - 1));
}

TEST_CASE("processes: sums over parts add, and their largest numbers are the largest") {
    const Processes all = support::world();
    const int n = all.count();
    bodies::Sums<2> sums{std::vector<bodies::Forces<2>>(1)};
    sums.on[0].load.add(all.rank(), {1, 2});
    sums.gradients = 1;
    sums.unseen = all.rank();
    all.combine(sums);
    CHECK(sums.on[0].load.vector == bodies::Values<2>(1, 2) * (n * (n - 1) / 2));
    CHECK(sums.gradients == n);
    CHECK(sums.unseen == n - 1);
}

TEST_CASE("processes: bytes arrive") {
    const Processes all = support::world();
    if (all.is_first())
        for (int to = 1; to < all.count(); ++to)
            all.send(std::vector<char>(static_cast<std::size_t>(to), 'a'), to);
    else
        CHECK(all.receive(0) == std::vector<char>(static_cast<std::size_t>(all.rank()), 'a'));
}
