#pragma once

#include "readout_state.h"

#include <QRect>

class QPainter;
class QFont;

namespace lds::ui {

/// Paints the readout into `rect`; the parts move together when there is little width.
/// `font` is the widget's, the small texts are derived from it.
void paintReadout(QPainter* painter, const QRect& rect, const ReadoutState& state, const QFont& font);

} // namespace lds::ui
