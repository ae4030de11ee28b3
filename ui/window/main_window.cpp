#include "main_window_private.h"

#include "leave_question.h"
#include "sensors_panel.h"
#include "theme.h"

#include <QAction>
#include <QActionGroup>
#include <QCloseEvent>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QTabBar>
#include <QVBoxLayout>

namespace lds::ui {

using catalog::ItemId;
using sensor::Connection;
using sensor::SensorSession;

namespace {
const QString geometryKey = QStringLiteral("window/geometry");
const QString stateKey = QStringLiteral("window/state");
const QString themeKey = QStringLiteral("view/theme");
constexpr int stateVersion = 1;
} // namespace

MainWindow::MainWindow(sensor::Workspace& workspace, MessageLog& log, ports::Scheduler& scheduler,
                       QSettings& settings)
    : d(new Private{workspace, log, scheduler, settings})
{
    setObjectName(QStringLiteral("mainWindow"));
    d->actions = new WindowActions(this);
    d->desk = new CommandDesk(workspace, this);
    build();
    connectActions();
    connectCommandActions();
    connectViewActions();
    for (SensorSession* session : workspace.sessions())
        watchSession(session);
    connect(&workspace, &sensor::Workspace::added, this, &MainWindow::watchSession);
    connect(&workspace, &sensor::Workspace::currentChanged, this, &MainWindow::setSession);
    restore();
    setSession(workspace.current());
    centralWidget()->setFocus(); // no button waits to be pressed by accident
}

MainWindow::~MainWindow() = default;

void MainWindow::build()
{
    d->tools = new ToolRow(*d->actions, this);
    d->dock = new QDockWidget(tr("Sensors"), this);
    d->dock->setObjectName(QStringLiteral("sensorsDock"));
    d->dock->setFeatures(QDockWidget::DockWidgetClosable | QDockWidget::DockWidgetMovable);
    d->dock->setAllowedAreas(Qt::LeftDockWidgetArea | Qt::RightDockWidgetArea);
    auto* heading = new QLabel(tr("SENSORS"), d->dock);
    heading->setProperty("heading", true);
    heading->setContentsMargins(12, 12, 12, 8);
    heading->setAutoFillBackground(true);
    heading->setBackgroundRole(QPalette::Base);
    d->dock->setTitleBarWidget(heading);
    d->dock->setWidget(new SensorsPanel(d->workspace, *d->actions, d->dock));
    addDockWidget(Qt::LeftDockWidgetArea, d->dock);

    auto* centre = new QWidget(this);
    auto* column = new QVBoxLayout(centre);
    column->setContentsMargins(16, 12, 16, 12);
    column->setSpacing(8);
    d->readout = new Readout(centre);
    d->banners = new BannerArea(centre);
    d->notices = new SessionNotices(*d->banners);
    d->tabs = new QTabWidget(centre);
    d->tabs->setObjectName(QStringLiteral("pages"));
    d->tabs->setDocumentMode(true);
    d->tabs->tabBar()->setDrawBase(false);
    d->tabs->tabBar()->setExpanding(false);
    d->settingsPage = new SettingsPage;
    d->trendPage = new TrendPage(d->scheduler);
    d->messagesPage = new MessagesPage(d->log);
    d->tabs->addTab(d->settingsPage, tr("Settings"));
    d->tabs->addTab(d->trendPage, tr("Trend"));
    d->tabs->addTab(d->messagesPage, tr("Messages"));
    d->stack = new QStackedWidget(centre);
    d->emptyPage = new EmptyPage(*d->actions, d->stack);
    d->stack->addWidget(d->emptyPage);
    d->stack->addWidget(d->tabs);
    column->addWidget(d->readout);
    column->addWidget(d->banners);
    column->addWidget(d->stack, 1);
    setCentralWidget(centre);

    d->status = new StatusLine(d->scheduler, this);
    setStatusBar(d->status);

    // Menu bar and tool row together: the row belongs to the window, not to its movable toolbars.
    auto* menus = new QMenuBar(this);
    d->actions->buildMenus(menus, d->dock->toggleViewAction());
    auto* top = new QWidget(this);
    auto* topColumn = new QVBoxLayout(top);
    topColumn->setContentsMargins(0, 0, 0, 0);
    topColumn->setSpacing(0);
    topColumn->setMenuBar(menus);
    topColumn->addWidget(d->tools);
    setMenuWidget(top);
}

void MainWindow::connectActions()
{
    const WindowActions& a = *d->actions;
    connect(a.connectSensor, &QAction::triggered, this, &MainWindow::openConnectDialog);
    connect(a.demo, &QAction::triggered, this, &MainWindow::demoRequested);
    connect(a.scan, &QAction::triggered, this, [this] { openScan(); });
    connect(a.changeCommunication, &QAction::triggered, this, &MainWindow::openChangeCommunication);
    connect(a.openConnection, &QAction::triggered, this, [this] {
        if (!d->session)
            return;
        if (d->session->connection() == Connection::Closed)
            d->session->open();
        else
            d->session->retryNow();
    });
    connect(a.closeConnection, &QAction::triggered, this, [this] {
        if (d->session)
            d->session->close();
    });
    connect(a.rename, &QAction::triggered, this, &MainWindow::openRename);
    connect(a.remove, &QAction::triggered, this, &MainWindow::removeCurrent);
    connect(a.readAll, &QAction::triggered, this, [this] {
        if (d->session)
            d->session->readAll();
    });
    connect(a.quit, &QAction::triggered, this, &QWidget::close);
    connect(a.undo, &QAction::triggered, this, [this] {
        if (d->session)
            d->session->undo();
    });
    connect(a.redo, &QAction::triggered, this, [this] {
        if (d->session)
            d->session->redo();
    });
    connect(a.discard, &QAction::triggered, this, [this] {
        if (d->session)
            d->session->revertAll();
    });
    connect(a.review, &QAction::triggered, this, &MainWindow::openReview);
    connect(a.find, &QAction::triggered, this, [this] {
        showPage(Page::Settings);
        d->settingsPage->focusFilter();
    });
    connect(a.types, &QActionGroup::triggered, this, [this](QAction* action) {
        if (d->session)
            d->session->setModel(catalog::SensorModel(action->data().toInt()));
    });
    connect(a.about, &QAction::triggered, this, &MainWindow::showAbout);
}

void MainWindow::connectCommandActions()
{
    const WindowActions& a = *d->actions;
    const auto command = [this](QAction* action, ItemId item, catalog::Value value) {
        connect(action, &QAction::triggered, this, [this, item, value] { runOnCurrent(item, value); });
    };
    command(a.saveInSensor, ItemId::SetValueSaving, 0);
    command(a.zeroSet, ItemId::ZeroSetting, 1);
    command(a.zeroClear, ItemId::ZeroSetting, 0);
    command(a.resetValue, ItemId::MeasuredValueResetting, 0);
    command(a.communicationReset, ItemId::ResettingCommunicationSettings, 0);
    connect(a.laser, &QAction::triggered, this, [this] {
        if (d->session)
            runOnCurrent(ItemId::LaserStop, isLaserStopped(*d->session) ? 0 : 1);
    });
    connect(a.keyLock, &QAction::triggered, this,
            [this](bool on) { runOnCurrent(ItemId::KeyLock, on ? 1 : 0); });
    const auto choices = [this](QActionGroup* group, ItemId item) {
        connect(group, &QActionGroup::triggered, this,
                [this, item](QAction* action) { runOnCurrent(item, action->data().toInt()); });
    };
    choices(a.banks, ItemId::BankSwitching);
    choices(a.bankCopies, ItemId::BankCopy);
    choices(a.initializations, ItemId::SettingsInitialization);
    connect(d->settingsPage, &SettingsPage::commandRequested, this, &MainWindow::runOnCurrent);
    connect(d->desk, &CommandDesk::started, d->status, &StatusLine::sayUntilDone);
    connect(d->desk, &CommandDesk::succeeded, this, [this](const QString& text) {
        d->notices->hideFailure();
        d->status->say(text);
    });
    connect(d->desk, &CommandDesk::failed, this, [this](SensorSession* session, const QString& sentence) {
        d->status->say({});
        if (session == d->session)
            d->notices->showFailure(sentence);
        else
            d->status->say(QStringLiteral("%1: %2").arg(session->name(), sentence));
        updateActions(); // a checkable action shows the sensor's state again
    });
    connect(d->notices, &SessionNotices::laserOnRequested, this,
            [this] { runOnCurrent(ItemId::LaserStop, 0); });
    connect(d->notices, &SessionNotices::typeRequested, this, &MainWindow::chooseType);
    connect(d->notices, &SessionNotices::reviewRequested, this, &MainWindow::openReview);
    connect(d->notices, &SessionNotices::itemRequested, this, &MainWindow::jumpTo);
}

void MainWindow::connectViewActions()
{
    const WindowActions& a = *d->actions;
    connect(a.pages, &QActionGroup::triggered, this,
            [this](QAction* action) { showPage(Page(action->data().toInt())); });
    connect(d->tabs, &QTabWidget::currentChanged, this,
            [this](int index) { d->actions->pages->actions().at(index)->setChecked(true); });
    a.pages->actions().first()->setChecked(true);
    connect(a.themes, &QActionGroup::triggered, this, [this](QAction* action) {
        Theme::instance().setMode(ThemeMode(action->data().toInt()));
        d->settings.setValue(themeKey, action->data());
    });
    const auto showTheme = [this] {
        d->actions->themes->actions().at(int(Theme::instance().mode()))->setChecked(true);
    };
    connect(&Theme::instance(), &Theme::changed, this, showTheme);
    showTheme();
}

void MainWindow::watchSession(SensorSession* session)
{
    const auto mine = [this, session](auto work) {
        return [this, session, work] {
            if (session == d->session)
                work();
        };
    };
    const auto update = mine([this] { updateActions(); });
    connect(session, &SensorSession::connectionChanged, this, update);
    connect(session, &SensorSession::readinessChanged, this, update);
    connect(session, &SensorSession::busyChanged, this, update);
    connect(session, &SensorSession::pendingChanged, this, update);
    connect(session, &SensorSession::savedChanged, this, update);
    connect(session, &SensorSession::heldChanged, this, update);
    connect(session, &SensorSession::identityChanged, this, update);
    connect(session, &SensorSession::identityChanged, this, mine([this] { showPeer(); }));
    connect(session, &SensorSession::measured, this, mine([this] { updateLaser(); }));
}

void MainWindow::setSession(SensorSession* session)
{
    d->session = session;
    if (d->reviewDialog)
        d->reviewDialog->close();
    d->readout->setSession(session);
    d->settingsPage->setSession(session);
    d->trendPage->setSession(session);
    d->status->setSession(session);
    d->notices->setSession(session);
    showPeer();
    d->stack->setCurrentWidget(session ? static_cast<QWidget*>(d->tabs) : d->emptyPage);
    updateActions();
}

/// The messages page is told whose messages it shows; a sensor can move to another address.
void MainWindow::showPeer()
{
    if (d->session)
        d->messagesPage->setPeer(d->session->url().peer().toString());
}

void MainWindow::updateActions()
{
    const WindowActions& a = *d->actions;
    const SensorSession* session = d->session;
    const bool exists = session != nullptr;
    const bool ready = exists && session->isReady();
    const bool canRun = ready && session->canWrite() && !session->isRunning() && !session->isApplying();
    const bool closed = exists && session->connection() == Connection::Closed;

    a.openConnection->setEnabled(exists && (closed || session->connection() == Connection::Reconnecting));
    a.closeConnection->setEnabled(exists && !closed);
    a.types->setEnabled(exists);
    for (QAction* action : {a.rename, a.remove, a.find})
        action->setEnabled(exists);
    a.readAll->setEnabled(ready);
    for (QAction* action :
         {a.saveInSensor, a.zeroSet, a.zeroClear, a.resetValue, a.laser, a.keyLock, a.communicationReset})
        action->setEnabled(canRun);
    const bool onSerial = exists && session->url().protocol == ports::Protocol::ModbusRtu;
    a.changeCommunication->setVisible(d->links != nullptr);
    a.changeCommunication->setEnabled(canRun && onSerial);
    for (QActionGroup* group : {a.banks, a.bankCopies, a.initializations})
        group->setEnabled(canRun);

    const int edits = exists ? session->pending().count() : 0;
    a.undo->setEnabled(exists && session->pending().canUndo());
    a.redo->setEnabled(exists && session->pending().canRedo());
    a.discard->setEnabled(edits > 0);
    a.review->setEnabled(edits > 0);
    a.review->setIconText(edits > 0 ? tr("Review and apply (%1)").arg(edits) : tr("Review and apply"));

    const auto held = [&](ItemId item) { return exists ? session->held(item).value_or(0) : 0; };
    a.keyLock->setChecked(held(ItemId::KeyLock) != 0);
    for (QAction* action : a.banks->actions())
        action->setChecked(exists && action->data().toInt() == held(ItemId::BankSwitching));
    for (QAction* action : a.types->actions())
        action->setChecked(exists && session->modelIsStated() &&
                           action->data().toInt() == int(session->model()));
    updateLaser();
    d->tools->showSaved(session);
    updateTitle();
}

void MainWindow::updateLaser()
{
    const bool stopped = d->session && isLaserStopped(*d->session);
    QAction* laser = d->actions->laser;
    laser->setText(stopped ? tr("&Laser: off") : tr("&Laser: on"));
    laser->setToolTip(stopped ? tr("The laser is off; press to switch it on")
                              : tr("The laser is on; press to stop it"));
    laser->setIcon(Theme::instance().icon(stopped ? QStringLiteral("laser-off") : QStringLiteral("laser")));
}

void MainWindow::updateTitle()
{
    setWindowTitle(d->session ? tr("%1[*] \u2013 LDS Studio").arg(d->session->name())
                              : QStringLiteral("LDS Studio"));
    setWindowModified(d->session && !d->session->pending().isEmpty());
}

void MainWindow::showPage(Page page) { d->tabs->setCurrentIndex(int(page)); }

void MainWindow::offerDemo() { d->actions->demo->setVisible(true); }

void MainWindow::addDock(QDockWidget* dock)
{
    if (!restoreDockWidget(dock)) { // adding it first would forget its place
        addDockWidget(Qt::RightDockWidgetArea, dock);
        dock->hide();
    }
    QMenu* view = d->actions->viewMenu(); // beside the other dock, before the themes
    view->insertAction(view->actions().last(), dock->toggleViewAction());
}

void MainWindow::runOnCurrent(ItemId item, catalog::Value value) { d->desk->run(d->session, item, value); }

void MainWindow::jumpTo(ItemId item)
{
    if (d->reviewDialog)
        d->reviewDialog->close();
    showPage(Page::Settings);
    d->settingsPage->showItem(item);
}

void MainWindow::setSerial(const ports::SerialPorts& ports, ports::BusScanFactory& scans,
                           ports::LinkFactory& links)
{
    d->serialPorts = &ports;
    d->scans = &scans;
    d->links = &links;
    d->actions->scan->setVisible(true);
    updateActions();
}

bool MainWindow::finishEditing()
{
    if (d->settingsPage->finishEditing())
        return true;
    showPage(Page::Settings); // where the text that is no value says what to do
    return false;
}

void MainWindow::chooseType()
{
    d->actions->typeMenu()->popup(d->banners->mapToGlobal(d->banners->rect().bottomLeft()));
}

void MainWindow::restore()
{
    setMinimumSize(900, 600);
    resize(1280, 800);
    restoreGeometry(d->settings.value(geometryKey).toByteArray());
    restoreState(d->settings.value(stateKey).toByteArray(), stateVersion);
}

void MainWindow::store()
{
    d->settings.setValue(geometryKey, saveGeometry());
    d->settings.setValue(stateKey, saveState(stateVersion));
}

void MainWindow::closeEvent(QCloseEvent* event)
{
    if (!d->leaving && !finishEditing()) {
        event->ignore();
        return;
    }
    if (d->leaving || lossesOf(d->workspace.sessions()).isEmpty()) {
        store();
        event->accept();
        return;
    }
    event->ignore();
    if (findChild<QMessageBox*>(QStringLiteral("leaveQuestion")))
        return;
    askBeforeLeaving(this, d->workspace.sessions(), tr("Close LDS Studio?"), tr("Close and leave it so"),
                     [this] {
                         d->leaving = true;
                         close();
                     });
}

} // namespace lds::ui
