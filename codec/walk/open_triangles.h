// Finds the open triangles of a front by their vertices; no two have the same. Most that are asked
// for are not there, which the vertices know nearly always. The others are in a short list of their
// newest vertex, near by what the walk has just touched. Those of a vertex that many crowd around
// are in a hash instead. Where many crowd into one place of it, it grows, or becomes another hash:
// no choice of vertices fits them all.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "walk/walk.h"

namespace ravel {

class OpenTriangles {
  public:
    using Vertices = std::array<Id, 3>;

    // `vertices_of(t)`: those of a triangle that is in here.
    template <class VerticesOf>
    void insert(Id triangle, const VerticesOf& vertices_of) {
        const Key key = key_of(vertices_of(triangle));
        if (key[2] >= around_.size()) around_.resize(std::size_t{key[2]} + kMoreVertices);
        for (const Id v : key) around_[v].signs |= sign_of(key);
        List& list = around_[key[2]].newest_of;
        if (list.count < kCrowd) {
            push(list, triangle);
            if (list.count < kCrowd) return;
            for (Id t = list.first; t != kNone; t = links_[t].next)
                insert_in_hash(t, key_of(vertices_of(t)), vertices_of);
        } else {
            insert_in_hash(triangle, key, vertices_of);
        }
    }
    void erase(Id triangle, const Vertices& vertices) {
        const Key key = key_of(vertices);
        if (key[2] >= around_.size()) return;
        List& list = around_[key[2]].newest_of;
        if (list.count < kCrowd)
            pull(list, triangle);
        else
            erase_in_hash(triangle, key);
    }
    // The triangle with these vertices, or kNone.
    template <class VerticesOf>
    Id find(const Vertices& vertices, const VerticesOf& vertices_of) const {
        if (!may_be_here(vertices)) return kNone;
        const Key key = key_of(vertices);
        const List& list = around_[key[2]].newest_of;
        if (list.count == kCrowd) return find_in_hash(key, vertices_of);
        Id t = list.first;
        while (t != kNone && key_of(vertices_of(t)) != key) t = links_[t].next;
        return t;
    }
    // How many places the hash has, and how often it became another one.
    std::size_t places() const { return table_.size(); }
    std::uint64_t changes() const { return change_; }

  private:
    using Key = Vertices;  // in order
    static constexpr Id kErased = kNone - 1;
    static constexpr std::uint32_t kCrowd = 32;
    static constexpr int kMostProbes = 48;
    static constexpr std::size_t kMoreVertices = 1024;

    // The open triangles of which a vertex is the newest. With kCrowd at once they move to the
    // hash, and so do all that follow: the list stays as it was.
    struct List {
        Id first = kNone;
        std::uint32_t count = 0;
    };
    struct Vertex {
        std::uint64_t signs = 0;  // of all triangles with it that were in here
        List newest_of;
    };
    struct Link {
        Id next = kNone, prev = kErased;  // kErased: in no list
    };

    static Key key_of(const Vertices& v) {
        const Id low = std::min(v[0], v[1]), high = std::max(v[0], v[1]);
        return {std::min(low, v[2]), std::max(low, std::min(high, v[2])), std::max(high, v[2])};
    }
    // One bit of 64, the same in any order.
    static std::uint64_t sign_of(const Vertices& v) {
        const auto share = [](Id id) {
            const std::uint32_t h = id * 0x9E3779B1u;
            return (h ^ h >> 15) * 0x85EBCA77u;
        };
        return std::uint64_t{1} << ((share(v[0]) + share(v[1]) + share(v[2])) >> 26);
    }
    // In whatever order the vertices are: all but few of those asked about are not.
    bool may_be_here(const Vertices& v) const {
        return std::max({v[0], v[1], v[2]}) < around_.size() &&
               (around_[v[0]].signs & around_[v[1]].signs & around_[v[2]].signs & sign_of(v)) != 0;
    }

    void push(List& list, Id triangle) {
        if (triangle >= links_.size())
            links_.resize(std::max<std::size_t>(triangle + std::size_t{1}, links_.size() * 3 / 2));
        links_[triangle] = {list.first, kNone};
        if (list.first != kNone) links_[list.first].prev = triangle;
        list.first = triangle;
        ++list.count;
    }
    void pull(List& list, Id triangle) {
        if (triangle >= links_.size() || links_[triangle].prev == kErased) return;
        const Link link = links_[triangle];
        links_[triangle].prev = kErased;
        if (link.next != kNone) links_[link.next].prev = link.prev;
        (link.prev == kNone ? list.first : links_[link.prev].next) = link.next;
        --list.count;
    }

    template <class VerticesOf>
    void insert_in_hash(Id triangle, const Key& key, const VerticesOf& vertices_of) {
        if (2 * (used_ + 1) > table_.size()) rehash(false, vertices_of);
        while (!place(triangle, key)) rehash(true, vertices_of);
        ++live_;
    }
    void erase_in_hash(Id triangle, const Key& key) {
        std::size_t i = home_of(hash_of(key));
        for (int probe = 0; probe < kMostProbes && table_[i] != kNone; ++probe, i = next(i))
            if (table_[i] == triangle) {
                table_[i] = kErased;
                --live_;
                return;
            }
    }
    template <class VerticesOf>
    Id find_in_hash(const Key& key, const VerticesOf& vertices_of) const {
        std::size_t i = home_of(hash_of(key));
        for (int probe = 0; probe < kMostProbes && table_[i] != kNone; ++probe, i = next(i))
            if (table_[i] != kErased && key_of(vertices_of(table_[i])) == key) return table_[i];
        return kNone;
    }
    std::uint64_t hash_of(const Key& v) const {
        std::uint64_t h = (v[0] + (change_ << 32)) * 0x9E3779B97F4A7C15u;
        h = (h ^ (h >> 29) ^ v[1]) * 0xBF58476D1CE4E5B9u;
        h = (h ^ (h >> 32) ^ v[2]) * 0x94D049BB133111EBu;
        return h ^ (h >> 31);
    }
    std::size_t home_of(std::uint64_t hash) const { return hash & (table_.size() - 1); }
    std::size_t next(std::size_t i) const { return (i + 1) & (table_.size() - 1); }
    // False where all places near its own are taken.
    bool place(Id triangle, const Key& key) {
        std::size_t i = home_of(hash_of(key));
        for (int probe = 0; probe < kMostProbes; ++probe, i = next(i))
            if (table_[i] >= kErased) {
                if (table_[i] == kNone) ++used_;
                table_[i] = triangle;
                return true;
            }
        return false;
    }
    template <class VerticesOf>
    void rehash(bool crowded, const VerticesOf& vertices_of) {
        std::vector<Id> old;
        old.swap(table_);
        std::size_t size = std::max<std::size_t>(64, old.size());
        for (bool fits = false; !fits; crowded = true) {
            if (size < 3 * (live_ + 16) || (crowded && size < 8 * live_))
                size *= 2;
            else
                change_ += crowded;
            table_.assign(size, kNone);
            used_ = 0;
            fits = true;
            for (const Id t : old)
                if (t < kErased && fits) fits = place(t, key_of(vertices_of(t)));
        }
    }

    std::vector<Vertex> around_;
    std::vector<Link> links_;  // per triangle
    std::vector<Id> table_;    // the hash: open addressing, linear probing
    std::size_t used_ = 0, live_ = 0;
    std::uint64_t change_ = 0;
};

}  // namespace ravel
