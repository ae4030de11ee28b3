#pragma once

#include <QStyledItemDelegate>

namespace lds::ui {

class RowEditor;
class SettingsModel;

/// Paints the rows and makes the editor that fits an item. An editor with wrong text stays open; what it
/// holds is kept in the model when the view has to destroy it (filter, collapse, another sensor).
class ItemDelegate final : public QStyledItemDelegate {
    Q_OBJECT

public:
    ItemDelegate(SettingsModel& model, QObject* parent);

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const override;
    void setEditorData(QWidget* editor, const QModelIndex& index) const override;
    void setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const override;
    void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                              const QModelIndex& index) const override;
    void destroyEditor(QWidget* editor, const QModelIndex& index) const override;

    /// Commits and closes, or keeps it open and says why not. True when it is closed.
    bool finish(QWidget* editor);

Q_SIGNALS:
    void orderRequested(const QModelIndex& index); ///< The button of the row was pressed.
    void entered();                                ///< Committed with Enter: on to the next row.
    void tabbed(bool forward);                     ///< Committed with Tab: edit the next row.
    void editorOpened(QWidget* editor);
    void editorClosed(QWidget* editor); ///< It is about to be deleted.

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    bool editorEvent(QEvent* event, QAbstractItemModel* model, const QStyleOptionViewItem& option,
                     const QModelIndex& index) override;

private:
    bool keyPressed(QWidget* widget, RowEditor& editor, const class QKeyEvent& event);
    void keepWrongInput(const RowEditor& editor) const;

    SettingsModel& m_model;
};

} // namespace lds::ui
