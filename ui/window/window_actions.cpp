#include "window_actions.h"

#include "catalog.h"
#include "item_text.h"
#include "theme.h"

#include <QAction>
#include <QActionGroup>
#include <QMenu>
#include <QMenuBar>

namespace lds::ui {

using catalog::Catalog;
using catalog::ItemId;

WindowActions::WindowActions(QObject* parent)
    : QObject(parent)
{
    makeSensorActions();
    makeEditActions();
    makeCommandActions();
    makeViewActions();
}

QAction* WindowActions::make(const char* name, const QString& text, const QString& icon, const QString& tip)
{
    auto* action = new QAction(text, this);
    action->setObjectName(QLatin1StringView(name));
    if (!icon.isEmpty())
        action->setIcon(Theme::instance().icon(icon));
    action->setToolTip(tip);
    action->setStatusTip({});
    return action;
}

QActionGroup* WindowActions::makeChoices(const char* name, int item)
{
    auto* group = new QActionGroup(this);
    group->setObjectName(QLatin1StringView(name));
    for (const auto& choice : Catalog::hlG2().item(ItemId(item)).choices) {
        auto* action = group->addAction(choiceName(choice));
        action->setObjectName(QStringLiteral("%1.%2").arg(QLatin1StringView(name)).arg(choice.code));
        action->setData(choice.code);
    }
    return group;
}

void WindowActions::makeSensorActions()
{
    connectSensor =
        make("connect", tr("&Connect…"), QStringLiteral("connect"), tr("Connect a sensor by its address"));
    connectSensor->setShortcut(Qt::CTRL | Qt::Key_K);
    connectSensor->setIconText(tr("Connect…"));
    scan = make("scan", tr("Scan an RS-&485 line…"), QStringLiteral("search"),
                tr("Finds sensors by speed, parity and address"));
    scan->setVisible(false);
    demo = make("demo", tr("Try with a &virtual sensor"), QStringLiteral("play"),
                tr("Connects a sensor that this program simulates"));
    demo->setVisible(false);
    openConnection = make("openConnection", tr("Connect a&gain"), QStringLiteral("refresh"),
                          tr("Connects the selected sensor now"));
    closeConnection = make("closeConnection", tr("&Disconnect"), QStringLiteral("disconnect"),
                           tr("Ends the connection; edits not applied stay"));
    changeCommunication = make("changeCommunication", tr("Change address, speed and parit&y…"), {},
                               tr("Writes, saves, resets and reconnects in one step; for sensors on RS-485"));
    rename = make("rename", tr("Re&name…"), QStringLiteral("edit"), tr("Gives the sensor a name of its own"));
    remove = make("remove", tr("Remove from the &list"), QStringLiteral("remove"),
                  tr("Takes the sensor off the list; the sensor itself stays as it is"));
    readAll = make("readAll", tr("Read &all"), QStringLiteral("read-all"),
                   tr("Reads every setting from the sensor again"));
    readAll->setShortcut(Qt::Key_F5);
    saveInSensor = make("saveInSensor", tr("&Save in sensor"), QStringLiteral("save"),
                        tr("Saves the settings so that they outlast power-off. The sensor may stay silent "
                           "for seconds"));
    saveInSensor->setShortcut(QKeySequence::Save);
    quit = make("quit", tr("&Quit"), {}, {});
    quit->setShortcut(Qt::CTRL | Qt::Key_Q);
    quit->setMenuRole(QAction::QuitRole);

    types = new QActionGroup(this);
    types->setObjectName(QStringLiteral("types"));
    for (const auto& model : Catalog::hlG2().models()) {
        auto* action = types->addAction(
            tr("%1 (%2 mm)").arg(QString::fromLatin1(model.typeName)).arg(model.centerDistance));
        action->setObjectName(QStringLiteral("types.%1").arg(int(model.model)));
        action->setData(int(model.model));
        action->setCheckable(true);
    }
}

void WindowActions::makeEditActions()
{
    undo = make("undo", tr("&Undo"), QStringLiteral("undo"), tr("Takes the last edit back"));
    undo->setShortcut(QKeySequence::Undo);
    redo = make("redo", tr("&Redo"), QStringLiteral("redo"), tr("Makes the edit again"));
    redo->setShortcuts({QKeySequence(Qt::CTRL | Qt::Key_Y), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z)});
    review = make("review", tr("Review and a&pply"), QStringLiteral("review"),
                  tr("Shows old and new values before anything is written"));
    review->setShortcuts({QKeySequence(Qt::CTRL | Qt::Key_Return), QKeySequence(Qt::CTRL | Qt::Key_Enter)});
    discard = make("discard", tr("&Discard all edits"), QStringLiteral("clear"),
                   tr("Takes all edits of this sensor back; Undo brings them again"));
    find = make("find", tr("&Find a setting"), QStringLiteral("search"),
                tr("Goes to the filter by number, name or value"));
    find->setShortcut(QKeySequence::Find);
}

void WindowActions::makeCommandActions()
{
    zeroSet = make("zeroSet", tr("&Zero set"), QStringLiteral("zero"),
                   tr("Makes the value at this place zero, or the offset if one is set"));
    zeroSet->setShortcut(Qt::Key_F8);
    zeroClear = make("zeroClear", tr("&Clear zero set"), {}, tr("Takes the zero set back"));
    zeroClear->setShortcut(Qt::SHIFT | Qt::Key_F8);
    resetValue = make("resetValue", tr("&Reset value"), QStringLiteral("reset"),
                      tr("Forgets gathered and held values; judgment outputs go off"));
    resetValue->setShortcut(Qt::Key_F9);
    laser = make("laser", tr("&Laser: on"), QStringLiteral("laser"), tr("Switches the laser beam"));
    laser->setShortcut(Qt::CTRL | Qt::Key_L);
    keyLock = make("keyLock", tr("Lock the sensor's &keys"), QStringLiteral("lock"),
                   tr("Keeps settings from being changed at the sensor"));
    keyLock->setCheckable(true);
    communicationReset = make("communicationReset", tr("Reset &communication settings…"), {},
                              tr("Makes changed communication settings take effect"));
    banks = makeChoices("banks", int(ItemId::BankSwitching));
    for (QAction* action : banks->actions())
        action->setCheckable(true);
    bankCopies = makeChoices("bankCopies", int(ItemId::BankCopy));
    initializations = makeChoices("initializations", int(ItemId::SettingsInitialization));
}

void WindowActions::makeViewActions()
{
    pages = new QActionGroup(this);
    const QStringList names{tr("&Settings"), tr("&Trend"), tr("&Messages")};
    const QStringList icons{QStringLiteral("settings"), QStringLiteral("trend"), QStringLiteral("messages")};
    for (int index = 0; index < names.size(); ++index) {
        auto* action = pages->addAction(Theme::instance().icon(icons.at(index)), names.at(index));
        action->setObjectName(QStringLiteral("page.%1").arg(index));
        action->setShortcut(QKeySequence(Qt::CTRL | Qt::Key(Qt::Key_1 + index)));
        action->setCheckable(true);
        action->setData(index);
    }
    themes = new QActionGroup(this);
    const QStringList modes{tr("As the &system"), tr("&Light"), tr("&Dark")};
    for (int index = 0; index < modes.size(); ++index) {
        auto* action = themes->addAction(modes.at(index));
        action->setObjectName(QStringLiteral("theme.%1").arg(index));
        action->setCheckable(true);
        action->setData(index);
    }
    about = make("about", tr("&About LDS Studio"), QStringLiteral("info"), {});
    about->setMenuRole(QAction::AboutRole);
}

void WindowActions::buildMenus(QMenuBar* bar, QAction* dockToggle)
{
    QMenu* sensor = bar->addMenu(tr("&Sensor"));
    sensor->addActions({connectSensor, scan, demo});
    sensor->addSeparator();
    sensor->addActions({openConnection, closeConnection});
    m_typeMenu = sensor->addMenu(tr("&Type"));
    m_typeMenu->addActions(types->actions());
    sensor->addActions({changeCommunication, rename, remove});
    sensor->addSeparator();
    sensor->addActions({readAll, saveInSensor});
    sensor->addSeparator();
    sensor->addAction(quit);

    QMenu* edit = bar->addMenu(tr("&Edit"));
    edit->addActions({undo, redo, discard});
    edit->addSeparator();
    edit->addActions({review, find});

    QMenu* commands = bar->addMenu(tr("&Commands"));
    commands->addActions({zeroSet, zeroClear, resetValue, laser, keyLock});
    commands->addSeparator();
    commands->addMenu(tr("&Bank"))->addActions(banks->actions());
    commands->addMenu(tr("C&opy a bank"))->addActions(bankCopies->actions());
    commands->addMenu(tr("&Initialise"))->addActions(initializations->actions());
    commands->addAction(communicationReset);

    m_viewMenu = bar->addMenu(tr("&View"));
    m_viewMenu->addActions(pages->actions());
    m_viewMenu->addSeparator();
    m_viewMenu->addAction(dockToggle);
    m_viewMenu->addMenu(tr("T&heme"))->addActions(themes->actions());

    bar->addMenu(tr("&Help"))->addAction(about);
}

} // namespace lds::ui
