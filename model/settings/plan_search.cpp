#include "plan_search.h"

#include "judgement.h"

#include <algorithm>
#include <map>
#include <queue>
#include <vector>

namespace lds::settings {

namespace {

using Key = std::vector<std::optional<Value>>;

struct Node {
    Values state;
    int cost = 0;
    const Node* cameFrom = nullptr;
    Write write;
    bool isSettled = false;
};

Key keyOf(const QList<ItemId>& items, const Values& state)
{
    Key key;
    key.reserve(std::size_t(items.size()));
    for (const ItemId item : items)
        key.push_back(known(state, item));
    return key;
}

QList<Write> wayTo(const Node& node)
{
    QList<Write> way;
    for (const Node* step = &node; step->cameFrom; step = step->cameFrom)
        way.prepend(step->write);
    return way;
}

/// Dijkstra's algorithm; equal costs are settled in the order of discovery, so the result is one and the
/// same on every machine.
class Search {
public:
    Search(catalog::SensorModel model, const QList<ItemId>& items, const QList<Move>& moves)
        : m_model(model)
        , m_items(items)
        , m_moves(moves)
    {}

    std::optional<QList<Write>> run(const Values& start, const Values& goal)
    {
        const Key goalKey = keyOf(m_items, goal);
        reach(start, nullptr, {}, 0);
        while (!m_open.empty()) {
            Node* node = m_open.top().node;
            m_open.pop();
            if (node->isSettled)
                continue;
            node->isSettled = true;
            if (keyOf(m_items, node->state) == goalKey)
                return wayTo(*node);
            for (const Move& move : m_moves)
                tryMove(*node, move);
        }
        return std::nullopt;
    }

private:
    struct Entry {
        int cost;
        int discovery;
        Node* node;
        bool operator<(const Entry& other) const // std::priority_queue serves the largest first
        {
            return std::tie(other.cost, other.discovery) < std::tie(cost, discovery);
        }
    };

    void tryMove(const Node& node, const Move& move)
    {
        const bool changesSomething =
            std::any_of(move.write.begin(), move.write.end(),
                        [&](const ItemValue& each) { return known(node.state, each.item) != each.value; });
        if (!changesSomething)
            return;
        if (const auto next = apply(m_model, node.state, move.write))
            reach(*next, &node, move.write, node.cost + move.cost);
    }

    void reach(const Values& state, const Node* from, const Write& write, int cost)
    {
        const auto [place, isNew] = m_nodes.try_emplace(keyOf(m_items, state));
        Node& node = place->second;
        if (!isNew && node.cost <= cost)
            return;
        node = {state, cost, from, write, false};
        m_open.push({cost, m_discoveries++, &node});
    }

    catalog::SensorModel m_model;
    const QList<ItemId>& m_items;
    const QList<Move>& m_moves;
    std::map<Key, Node> m_nodes; ///< Its nodes stay where they are.
    std::priority_queue<Entry> m_open;
    int m_discoveries = 0;
};

} // namespace

std::optional<QList<Write>> cheapestWay(catalog::SensorModel model, const QList<ItemId>& items,
                                        const Values& start, const Values& goal, const QList<Move>& moves)
{
    return Search(model, items, moves).run(start, goal);
}

} // namespace lds::settings
