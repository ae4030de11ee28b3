#pragma once

#include <QObject>

class QAction;
class QActionGroup;
class QMenu;
class QMenuBar;

namespace lds::ui {

/// Everything the main window can do, with texts, keys and mnemonics; who does it connects to them.
class WindowActions final : public QObject {
    Q_OBJECT

public:
    explicit WindowActions(QObject* parent = nullptr);
    /// Fills the menu bar; `dockToggle` goes into the View menu.
    void buildMenus(QMenuBar* bar, QAction* dockToggle);

    // Sensor
    QAction* connectSensor;
    QAction* scan;           ///< Invisible until there is something to scan with.
    QAction* demo;           ///< Invisible until somebody offers a virtual sensor.
    QAction* openConnection; ///< Connect the sensor of the list again, or now.
    QAction* closeConnection;
    QAction* changeCommunication; ///< Address, speed and parity on RS-485, guided.
    QAction* rename;
    QAction* remove;
    QAction* readAll;
    QAction* saveInSensor;
    QAction* quit;
    // Edit
    QAction* undo;
    QAction* redo;
    QAction* review;
    QAction* discard;
    QAction* find;
    // Commands
    QAction* zeroSet;
    QAction* zeroClear;
    QAction* resetValue;
    QAction* laser;
    QAction* keyLock;
    QAction* communicationReset;
    QActionGroup* banks;           ///< data(): 1 … 4
    QActionGroup* bankCopies;      ///< data(): the code of the command
    QActionGroup* initializations; ///< data(): the code of the command
    QActionGroup* types;           ///< data(): SensorModel
    // View
    QActionGroup* pages;  ///< data(): index
    QActionGroup* themes; ///< data(): ThemeMode
    QAction* about;

    QMenu* viewMenu() const { return m_viewMenu; }
    QMenu* typeMenu() const { return m_typeMenu; }

private:
    QAction* make(const char* name, const QString& text, const QString& icon, const QString& tip);
    QActionGroup* makeChoices(const char* name, int item);
    void makeSensorActions();
    void makeEditActions();
    void makeCommandActions();
    void makeViewActions();

    QMenu* m_viewMenu = nullptr;
    QMenu* m_typeMenu = nullptr;
};

} // namespace lds::ui
