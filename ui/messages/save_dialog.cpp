#include "save_dialog.h"

#include "messages_page.h"

#include <QDateTime>
#include <QFileDialog>

namespace lds::ui {

QFileDialog* makeSaveDialog(QWidget* parent)
{
    auto* dialog = new QFileDialog(parent, MessagesPage::tr("Save messages"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setNameFilters(
        {MessagesPage::tr("Table (*.csv)"), MessagesPage::tr("Text, tab separated (*.txt)")});
    dialog->setDefaultSuffix(QStringLiteral("csv"));
    QObject::connect(dialog, &QFileDialog::filterSelected, dialog, [dialog](const QString& filter) {
        dialog->setDefaultSuffix(filter.contains(QStringLiteral("*.txt")) ? QStringLiteral("txt")
                                                                          : QStringLiteral("csv"));
    });
    dialog->selectFile(QStringLiteral("messages-%1")
                           .arg(QDateTime::currentDateTime().toString(QStringLiteral("yyyyMMdd-HHmmss"))));
    return dialog;
}

} // namespace lds::ui
