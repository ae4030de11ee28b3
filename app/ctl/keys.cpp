#include "keys.h"

#include "texts.h"

#include <QStringList>

#include <algorithm>
#include <limits>
#include <numeric>

namespace lds::ctl {

namespace {

using catalog::Catalog;
using catalog::MenuEntry;
using catalog::WriteGroup;

QString keyOf(catalog::ItemId id) { return QString::fromLatin1(catalog::hlG2(id).key); }

/// What the keys of a group's items begin with in common: "ipAddress1stOctet", … give "ipAddress".
QString groupKey(const MenuEntry& entry)
{
    QString common = keyOf(entry.items.front());
    for (const catalog::ItemId id : entry.items) {
        const QString key = keyOf(id);
        const auto differs = std::mismatch(common.cbegin(), common.cend(), key.cbegin(), key.cend());
        common.truncate(differs.first - common.cbegin());
    }
    return common;
}

bool isGroup(const MenuEntry& entry)
{
    return entry.items.size() > 1 && catalog::hlG2(entry.items.front()).group != WriteGroup::None;
}

QList<Target> groups()
{
    QList<Target> found;
    for (const MenuEntry& entry : Catalog::hlG2().menu()) {
        if (isGroup(entry))
            found.append({groupKey(entry), QList<catalog::ItemId>(entry.items.begin(), entry.items.end())});
    }
    return found;
}

QStringList allKeys()
{
    QStringList keys;
    for (const auto& item : Catalog::hlG2().items())
        keys += QString::fromLatin1(item.key);
    for (const Target& group : groups())
        keys += group.key;
    return keys;
}

/// Letters to insert, delete or replace to get from one word to the other (Levenshtein).
qsizetype editDistance(const QString& from, const QString& to)
{
    QList<qsizetype> row(to.size() + 1);
    std::iota(row.begin(), row.end(), 0);
    for (qsizetype i = 0; i < from.size(); ++i) {
        qsizetype diagonal = row[0];
        row[0] = i + 1;
        for (qsizetype j = 0; j < to.size(); ++j) {
            const qsizetype replaced = diagonal + (from[i] == to[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
        }
    }
    return row.last();
}

/// Empty when nothing is near: a wild guess helps nobody.
QString nearestKey(const QString& typed)
{
    constexpr qsizetype longestWorthComparing = 64;
    if (typed.size() > longestWorthComparing)
        return {};
    const QString lower = typed.toLower();
    QString nearest;
    qsizetype best = std::numeric_limits<qsizetype>::max();
    const QStringList keys = allKeys();
    for (const QString& key : keys) {
        const qsizetype distance =
            lower.size() >= 4 && key.toLower().startsWith(lower) ? 1 : editDistance(lower, key.toLower());
        if (distance < best) {
            best = distance;
            nearest = key;
        }
    }
    return best <= std::max<qsizetype>(2, typed.size() / 3) ? nearest : QString();
}

} // namespace

std::optional<Target> findTarget(const QString& key)
{
    if (const auto* item = Catalog::hlG2().findByKey(key))
        return Target{key, {item->id}};
    const QList<Target> all = groups();
    const auto group = std::ranges::find(all, key, &Target::key);
    return group == all.end() ? std::nullopt : std::optional(*group);
}

QString groupKeyOf(catalog::ItemId item)
{
    const QList<Target> all = groups();
    const auto group =
        std::ranges::find_if(all, [item](const Target& target) { return target.items.contains(item); });
    return group == all.end() ? QString() : group->key;
}

QString unknownKeyMessage(const QString& key)
{
    const QString nearest = nearestKey(key);
    return nearest.isEmpty()
               ? Texts::tr("unknown key “%1”; “ldsctl catalog” lists all keys.").arg(key)
               : Texts::tr("unknown key “%1”; did you mean “%2”? “ldsctl catalog” lists all keys.")
                     .arg(key, nearest);
}

} // namespace lds::ctl
