#pragma once

class QFileDialog;
class QWidget;

namespace lds::ui {

/// Asks where messages are to be saved, as a table or as text, under a name that tells the time. Not shown
/// yet; deletes itself when it is closed.
QFileDialog* makeSaveDialog(QWidget* parent);

} // namespace lds::ui
