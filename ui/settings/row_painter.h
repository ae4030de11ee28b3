#pragma once

#include <QModelIndex>
#include <QRect>
#include <QStyleOptionViewItem>

class QPainter;

namespace lds::ui {

/// How a row of the settings looks: tints, bars, marks and where the figures stand.
namespace row_painter {

inline constexpr int height = 26;
inline constexpr int padding = 8;
inline constexpr int iconSize = 14;

struct RowLook {
    bool selected = false;
    bool hovered = false;
    bool current = false; ///< The row the keyboard acts on, while the tree has the focus.
};

/// Background, edge bar and lower line over the whole width.
void paintRow(QPainter* painter, const QRect& row, const QModelIndex& index, const RowLook& look);
/// The frame around the current row, over the cells.
void paintRowFrame(QPainter* painter, const QRect& row, const RowLook& look);
/// One cell's content without background. `hovered` lights its button.
void paintCell(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index);
/// Where the button of a "New value" cell is; empty without one.
QRect buttonRect(const QStyleOptionViewItem& option, const QModelIndex& index);
/// The width the cell's content takes, padding included.
int contentWidth(const QStyleOptionViewItem& option, const QModelIndex& index);

} // namespace row_painter
} // namespace lds::ui
