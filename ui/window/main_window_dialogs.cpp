// The dialogs the main window opens. None of them has an event loop of its own.
#include "main_window_private.h"

#include "leave_question.h"

#include <QInputDialog>
#include <QMessageBox>

namespace lds::ui {

using sensor::SensorSession;

void MainWindow::openConnectDialog()
{
    if (d->connectDialog)
        return;
    d->connectDialog = new ConnectDialog(d->workspace, RecentConnections(d->settings), d->serialPorts, this);
    connect(d->connectDialog, &ConnectDialog::scanRequested, this, &MainWindow::openScan);
    d->connectDialog->open();
}

void MainWindow::openScan(const QString& port)
{
    if (!d->scans || d->scanDialog)
        return;
    d->scanDialog = new ScanDialog(d->workspace, d->serialPorts, *d->scans, d->scheduler, this);
    if (!port.isEmpty())
        d->scanDialog->setPort(port);
    connect(d->scanDialog, &ScanDialog::sensorAdded, this, [this](const ports::ConnectionUrl& url) {
        RecentConnections(d->settings).add({url, {}});
    });
    d->scanDialog->open();
}

void MainWindow::openChangeCommunication()
{
    if (!d->session || !d->links || d->changeDialog)
        return;
    d->changeDialog = new ChangeCommunicationDialog(*d->session, d->workspace, *d->links, d->scheduler, this);
    connect(d->changeDialog, &ChangeCommunicationDialog::moved, this,
            [this, former = d->session->url()](const ports::ConnectionUrl& url) {
                RecentConnections recent(d->settings);
                QString name;
                for (const RecentConnection& each : recent.list()) {
                    if (sensor::isSameSensor(each.url, former))
                        name = each.name;
                }
                recent.add({url, name});
            });
    d->changeDialog->open();
}

void MainWindow::openReview()
{
    if (!d->session || d->reviewDialog || !finishEditing())
        return;
    d->reviewDialog = new ReviewDialog(*d->session, this);
    connect(d->reviewDialog, &ReviewDialog::jumpRequested, this, &MainWindow::jumpTo);
    connect(d->reviewDialog, &ReviewDialog::applied, d->status, &StatusLine::say);
    d->reviewDialog->open();
}

void MainWindow::openRename()
{
    if (!d->session)
        return;
    auto* dialog = new QInputDialog(this);
    dialog->setObjectName(QStringLiteral("renameDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Rename"));
    dialog->setLabelText(tr("Name of the sensor at %1:").arg(d->session->url().place()));
    dialog->setTextValue(d->session->name());
    connect(dialog, &QInputDialog::textValueSelected, d->session, &SensorSession::setName);
    dialog->open();
}

void MainWindow::removeCurrent()
{
    if (!d->session)
        return;
    const QPointer<SensorSession> session = d->session;
    askBeforeLeaving(this, {session}, tr("Remove %1 from the list?").arg(session->name()), tr("Remove"),
                     [this, session] {
                         if (session)
                             d->workspace.remove(session);
                     });
}

void MainWindow::showAbout()
{
    auto* box =
        new QMessageBox(QMessageBox::NoIcon, tr("About LDS Studio"),
                        tr("LDS Studio %1").arg(QStringLiteral(LDS_VERSION)), QMessageBox::Close, this);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setInformativeText(
        tr("Open configuration tool for laser displacement sensors.\nFree software under the GNU "
           "General Public License, version 3 or later, without any warranty.\nQt %1")
            .arg(QLatin1StringView(qVersion())));
    box->open();
}

} // namespace lds::ui
