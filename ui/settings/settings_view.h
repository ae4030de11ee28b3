#pragma once

#include <QPointer>
#include <QTreeView>

namespace lds::ui {

class ItemDelegate;
class SettingsModel;

/// The tree of the settings: one selected row, editing begins in "New value" wherever the row is used, and
/// an editor with wrong text is neither closed nor forgotten.
class SettingsView final : public QTreeView {
    Q_OBJECT

public:
    explicit SettingsView(QWidget* parent = nullptr);
    ~SettingsView() override;

    void setDelegate(ItemDelegate* delegate);
    /// Commits an open editor. False when its text is wrong: it has the focus then and says so.
    bool finishEditing();
    /// Before the rows go: what an editor holds is committed, or kept by the model when it is wrong.
    void releaseEditing();
    void editRow(const QModelIndex& index); ///< As F2 does; orders pop up their menu.
    void setEmptyText(const QString& text); ///< Shown while there are no rows.
    QString emptyText() const { return m_emptyText; }
    /// Takes the columns' widths from the rows there are; they only grow, unless `afresh`, so that a
    /// filter does not make them jump. Range and Default go when there is little room.
    void measureColumns(bool afresh = false);

Q_SIGNALS:
    void orderRequested(const QModelIndex& index);
    void revertRequested(const QModelIndex& index);
    void editRefused(const QModelIndex& index); ///< The row cannot be changed; say why.
    void copyRequested();
    void detailsRequested();
    void editingChanged(const QModelIndex& index); ///< Invalid when no editor is open.

protected:
    bool edit(const QModelIndex& index, EditTrigger trigger, QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void drawRow(QPainter* painter, const QStyleOptionViewItem& option,
                 const QModelIndex& index) const override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

protected Q_SLOTS:
    void closeEditor(QWidget* editor, QAbstractItemDelegate::EndEditHint hint) override;

private:
    void measureRows(const QModelIndex& parent, int depth);
    void fitColumns();
    /// Where a cell is painted: over its empty neighbours where its text needs the room.
    QRect paintedRect(const QModelIndex& cell) const;
    void drawArrow(QPainter* painter, const QModelIndex& index) const;
    QModelIndex nextRow(const QModelIndex& from, bool forward, bool editableOnly) const;
    bool isButtonRow(const QModelIndex& index) const;
    void pasteIntoRow();

    ItemDelegate* m_delegate = nullptr;
    QPointer<QWidget> m_editor;
    QString m_emptyText;
    QList<int> m_widths; ///< By column; empty before the first measuring.
    bool m_releasing = false;
};

} // namespace lds::ui
