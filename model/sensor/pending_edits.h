#pragma once

#include "session_types.h"

#include <optional>

namespace lds::sensor {

/// The edits a person has made and not applied, with undo and redo. A plain value object: the session
/// owns one and tells what the sensor holds.
///
/// The octets of an address are one change: an edit of one brings the others along as they are, they are
/// taken back together, and they come true together. An edit may therefore want what is held.
class PendingEdits {
public:
    using Edits = QMap<ItemId, PendingEdit>;

    const Edits& edits() const { return m_edits; }
    std::optional<PendingEdit> find(ItemId item) const;
    bool isEmpty() const { return m_edits.isEmpty(); }
    /// What a person counts: the four octets of an address are one change.
    int count() const;

    /// One undoable step. An edit that asks for what the sensor holds already is removed.
    void set(const QList<settings::ItemValue>& wanted, const settings::Values& held);
    void remove(const QList<ItemId>& items); ///< One undoable step.
    void clear();                            ///< One undoable step; undo brings the edits back.

    bool canUndo() const { return !m_undo.isEmpty(); }
    bool canRedo() const { return !m_redo.isEmpty(); }
    void undo(const settings::Values& held);
    void redo(const settings::Values& held);

    /// The sensor holds other values now: marks conflicts, drops edits that have come true. An edit of an
    /// item that each bank has its own of belongs to the bank it was made for: while another bank runs it
    /// is in conflict and never "true".
    void rebase(const settings::Values& held);
    /// This program changed the items itself: their edits follow without a conflict.
    void follow(const QList<ItemId>& items, const settings::Values& held);
    /// An applied edit is gone for good: undo must not write it again by surprise, so history forgets it.
    void applied(ItemId item);
    /// The person has seen the conflict and keeps the edit: its base is now what the sensor holds.
    void confirm(ItemId item, const settings::Values& held);

    settings::Values wantedValues() const;

private:
    void replace(Edits edits); ///< One undoable step; none when nothing differs.
    static Edits settled(Edits edits, const settings::Values& held);
    static bool wantSame(const Edits& left, const Edits& right);
    void forgetEmptySteps(const settings::Values& held);

    Edits m_edits;
    QList<Edits> m_undo; ///< Whole states: an edit list is small and implicitly shared.
    QList<Edits> m_redo;
};

} // namespace lds::sensor
